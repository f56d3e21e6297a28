"""The faces of a planar graph of edges: its bounded parts, of which the outlines at even depth are material, those at
odd depth holes; parts that touch have one depth."""
import math
from collections import Counter
from dataclasses import dataclass, field

from drawing import pieces
from drawing.joining import tree_of
from drawing.sketch import listed, place


@dataclass(frozen=True)
class Side:
    """An edge in one of its directions."""

    edge: object
    is_forward: bool

    @property
    def start(self):
        return self.edge.start if self.is_forward else self.edge.end

    @property
    def end(self):
        return self.edge.end if self.is_forward else self.edge.start

    def at(self, share):
        return self.edge.at(share if self.is_forward else 1 - share)

    def direction(self, distance):
        """To the point of the side at this distance from its start."""
        inside, outside = 0.0, next((i / 64 for i in range(1, 64) if abs(self.at(i / 64) - self.start) > distance), 1.0)
        for _ in range(40):
            share = (inside + outside) / 2
            if abs(self.at(share) - self.start) < distance:
                inside = share
            else:
                outside = share
        step = self.at(outside) - self.start
        return math.atan2(step.imag, step.real)


@dataclass
class Cycle:
    """Sides one behind the other, with one part of the plane on their left."""

    sides: list
    area: float
    component: int = -1


@dataclass
class Face:
    outline: Cycle
    holes: list = field(default_factory=list)


# ---- cycles


def sides_around(edges):
    """The sides that start at each vertex, counter-clockwise."""
    around = {}
    for i, edge in enumerate(edges):
        around.setdefault(edge.start, []).append((i, True))
        around.setdefault(edge.end, []).append((i, False))
    for found in around.values():
        if len(found) > 2:
            reach = min(pieces.size(edges[i].curve) for i, _ in found) / 100
            found.sort(key=lambda side: Side(edges[side[0]], side[1]).direction(reach))
    return around


def traced(edges):
    """The cycles: behind each side comes the next one clockwise at its end."""
    around = sides_around(edges)
    left, cycles = {(i, forward) for i in range(len(edges)) for forward in (True, False)}, []
    for first in [(i, forward) for i in range(len(edges)) for forward in (True, False)]:
        keys, key = [], first
        while key in left:
            left.remove(key)
            keys.append(key)
            i, forward = key
            found = around[edges[i].end if forward else edges[i].start]
            key = found[found.index((i, not forward)) - 1]
        if keys:
            cycles.append([Side(edges[i], forward) for i, forward in keys])
    return cycles


def area_of(sides, areas):
    return math.fsum(areas[side.edge] if side.is_forward else -areas[side.edge] for side in sides)


def area_beside(edge):
    return sum(pieces.area_beside(piece) for piece in edge.pieces())


def bridges_of(cycles):
    """Edges with one part of the plane on both sides."""
    return {edge for sides in cycles for edge, count in Counter(side.edge for side in sides).items() if count > 1}


def numbered_components(cycles):
    """Numbers the cycles by the connected part of the graph that they belong to."""
    parent = {}

    def first(z):
        while parent.setdefault(z, z) != z:
            parent[z] = parent[parent[z]]
            z = parent[z]
        return z

    for cycle in cycles:
        for side in cycle.sides:
            parent[first(side.start)] = first(side.end)
    numbers = {}
    for cycle in cycles:
        cycle.component = numbers.setdefault(first(cycle.sides[0].start), len(numbers))
    return len(numbers)


# ---- nesting


class Nesting:
    """Which bounded cycle of another component lies around a component, next to it."""

    def __init__(self, cycles):
        self.cycle_of = {(side.edge, side.is_forward): cycle for cycle in cycles for side in cycle.sides}
        self.pieces = [(edge, piece) for edge, forward in self.cycle_of if forward for piece in edge.pieces()]
        boxes = []
        for _, piece in self.pieces:
            parts = pieces.halved(piece, 3 if piece.bend else 0)
            points, reach = [z for part in parts for z in (part.a, part.b)], max(part.width for part in parts)
            across, up = [z.real for z in points], [z.imag for z in points]
            boxes.append((complex(min(across) - reach, min(up) - reach), complex(max(across) + reach, max(up) + reach)))
        self.tree, self.order = tree_of(boxes)

    def around(self, cycle):
        z, odd = cycle.sides[0].start, {}
        for i in self.tree.right_of(z):
            edge, piece = self.pieces[self.order[i]]
            if self.cycle_of[edge, True].component != cycle.component and pieces.is_crossed_by_ray(piece, z):
                for forward in (True, False):
                    found = self.cycle_of[edge, forward]
                    odd[id(found)] = None if odd.get(id(found)) else found
        found = [other for other in odd.values() if other and other.area > 0]
        return min(found, key=lambda other: other.area, default=None)


def faces_of(cycles, has_all_regions):
    """The faces that are material, in the order of their outlines' first edges."""
    count, nesting = numbered_components(cycles), Nesting(cycles)
    contours = [None] * count
    for cycle in sorted(cycles, key=lambda cycle: cycle.area):
        contours[cycle.component] = contours[cycle.component] or cycle
    parents = [nesting.around(contour) for contour in contours]
    depths = [0] * count  # by the areas of what lies around, the largest first
    for k in sorted(range(count), key=lambda k: contours[k].area):
        depths[k] = 0 if parents[k] is None else depths[parents[k].component] + 1
    faces = {id(cycle): Face(cycle) for cycle in cycles
             if cycle.area > 0 and (has_all_regions or depths[cycle.component] % 2 == 0)}
    for k, parent in enumerate(parents):
        if parent is not None and id(parent) in faces:
            faces[id(parent)].holes.append(contours[k])
    return list(faces.values())


def find_faces(sketch, edges, has_all_regions):
    """(faces, edges inside faces): of the edges of a graph without loose ends. Warns of edges that bound nothing."""
    inner = []
    while True:
        found = traced(edges)
        bridges = bridges_of(found)
        if not bridges:
            break
        inner += [edge for edge in edges if edge in bridges]
        edges = [edge for edge in edges if edge not in bridges]
    areas = {edge: area_beside(edge) for edge in edges}
    faces = faces_of([Cycle(sides, area_of(sides, areas)) for sides in found], has_all_regions)
    used = {side.edge for face in faces for cycle in (face.outline, *face.holes) for side in cycle.sides}
    idle = [edge for edge in edges if edge not in used]
    if idle:
        sketch.warnings.append(("W-DRW-003", "left out, as they lie inside holes and bound no face: " +
                                listed([f"{edge.label} at {place(edge.middle)}" for edge in idle])))
    return faces, inner


def name_of(face):
    """The name that all edges of its outline have, or others that lie upon them, else none."""
    names = set.intersection(*({side.edge.name, *side.edge.upon} for side in face.outline.sides))
    return min(names, default="")
