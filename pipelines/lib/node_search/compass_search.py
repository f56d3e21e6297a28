"""Compass search: each orbit of nodes is tried a step towards the nearest boundary, away from it and to both sides; a
move that comes nearer to the goal is kept; a round without such a move halves the step."""
import json
import shutil

from command_frame import Failure
from node_search import boundary, layouts
from node_search.goals import GOALS, LEAST_GAIN
from node_search.symmetries import Marks, orbits


def node_positions(nodes):
    return [complex(*point["position"]) for point in nodes["critical_points"]]


def moved_nodes(nodes, moves):
    """The content of x.crit.json with nodes elsewhere, as formats/critical-points.md, "Editing it", describes."""
    points = [dict(point) for point in nodes["critical_points"]]
    for k, move in moves.items():
        position = complex(*points[k]["position"]) + move
        points[k] = {"position": [position.real, position.imag], "valence": points[k]["valence"], "source": "hand"}
    return nodes | {"form": "phase", "critical_points": points}


def directions(position, boundary_points, orbit):
    """Unit vectors: towards the nearest boundary, away from it and to both sides, as far as symmetry allows."""
    towards = min(boundary_points, key=lambda point: abs(point - position)) - position
    found = []
    for quarter in (1, -1, 1j, -1j):
        direction = orbit.symmetric_part(towards / abs(towards) * quarter)
        if abs(direction) > 1e-3:
            direction /= abs(direction)
            if all(abs(direction - other) > 1e-3 for other in found):
                found.append(direction)
    return found


class Search:
    """`best`: the layout so far. `moves`: those that were kept, for the report. `report_move` gets a line for each."""

    def __init__(self, first, start, report_move, goal=GOALS["scaled-jacobian"]):
        graph = json.loads((start.folder / "sep.json").read_text())
        self.first, self.start, self.best, self.report_move, self.goal = first, start, start, report_move, goal
        self.diameter = graph["face"]["diameter"]
        self.boundary = boundary.boundary_points(graph["face"])
        marks = [((node["kind"], node["valence"]), complex(*node["position"])) for node in graph["nodes"]]
        self.orbits = orbits(node_positions(start.nodes), Marks(marks, self.diameter))
        self.trials, self.moves = 0, []
        self.num_layouts = 0  # trials that gave blocks

    def keep_if_better(self, moves):
        """Tries the best layout with these moves; the worse of the two is removed."""
        self.trials += 1
        folder = self.first / f"trial{self.trials}"
        layout = self.try_layout(moved_nodes(self.best.nodes, moves), folder)
        self.num_layouts += layout is not None
        if layout is None or not self.goal.is_better(layout, self.best, self.start):
            shutil.rmtree(folder)
            return False
        shutil.rmtree(self.best.folder)
        self.best = layout
        return True

    def try_layout(self, nodes, folder):
        """None if there is no layout with these nodes (1), or a node is not inside (3)."""
        try:
            return layouts.make_layout(nodes, folder, self.first, is_trial=True)
        except Failure as failure:
            if failure.code not in (1, 3):
                raise
            return None

    def move_orbit(self, orbit, step):
        """Keeps the first direction in which the layout is better; returns whether there is one."""
        position = node_positions(self.best.nodes)[orbit.first]
        for direction in directions(position, self.boundary, orbit):
            if self.keep_if_better(orbit.moves(direction * step)):
                self.record(sorted(orbit.maps), step, orbit.first, position + direction * step)
                return True
        return False

    def record(self, nodes, step, first, position):
        figure = self.goal.figure(self.best)
        self.moves.append({"nodes": nodes, "step": step / self.diameter, "quality": figure})
        self.report_move(f"nodes {', '.join(map(str, nodes))}: by {step:.3g}, node {first} to "
                         f"({position.real:.6g}, {position.imag:.6g}): {figure:.4g}")

    def reason_to_stay(self, rounds):
        """Why no node was moved in these rounds."""
        if not self.orbits:
            return "there is no irregular node inside"
        if not rounds and self.goal.is_reached(self.best):
            return "the blocks are as good as the valences allow"
        if not rounds:
            return "no round was allowed"
        if not self.trials:
            return "symmetry leaves the nodes no direction"
        if not self.num_layouts:
            return "no trial gave blocks: try a smaller --step"
        least = "" if self.goal is GOALS["blocks"] else f" by {LEAST_GAIN:g}"
        return f"no trial {self.goal.verb} it{least}: try a smaller --step or more --rounds"

    def run(self, rounds, step):
        """At most `rounds` rounds, the first with a step of `step` diameters; returns the number of rounds made."""
        made = 0
        while made < rounds and not self.goal.is_reached(self.best):
            made += 1
            gains = [self.move_orbit(orbit, step * self.diameter) for orbit in self.orbits]
            if not any(gains):
                step /= 2
        return made
