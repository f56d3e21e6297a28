"""Nodes, arcs and separatrices (formats/separatrix-graph.md)."""
import dataclasses
import functools

import numpy as np

from .face import Face, read_splines
from .stage_file import records
from .stage_result import StageResult


@dataclasses.dataclass
class GraphNode:
    """A node of the graph. `kind`: irregular, corner, boundary, crossing or cut; `curve`, `t`: where it lies on the
    boundary, else -1 and 0."""
    number: int
    position: np.ndarray
    kind: str
    valence: int
    curve: int
    t: float


class Arc:
    """A curve between two nodes: parts of CAD curves, or of splines inside the face.

    `number`; `start`, `end`: numbers of its nodes; `is_boundary`; `names`: the names of the CAD curves that it follows
    (empty inside); `pieces`: pairs of a Spline and its parameters (t0, t1).
    """

    def __init__(self, number, record, pieces, names):
        self.number, self.start, self.end = number, int(record["from"]), int(record["to"])
        self.is_boundary = bool(record["is_boundary"])
        self.pieces, self.names = pieces, names

    @functools.cached_property
    def _ends(self):
        """Arc lengths of the pieces' ends on their splines [p, 2], and from the arc's start to each piece's end [p]."""
        ends = np.array([spline.length_to([t0, t1]) for spline, t0, t1 in self.pieces])
        return ends, np.cumsum(np.abs(ends[:, 1] - ends[:, 0]))

    @property
    def arc_length(self):
        return float(self._ends[1][-1])

    def at(self, fraction):
        """Points [n, 2] at fractions [n] of the arc length, from 0 at the start to 1 at the end."""
        ends, until = self._ends
        length = np.clip(np.atleast_1d(np.asarray(fraction, float)), 0, 1) * until[-1]
        piece = np.minimum(np.searchsorted(until, length), len(until) - 1)
        points = np.empty((len(length), 2))
        for i, (spline, _, _) in enumerate(self.pieces):
            here = np.flatnonzero(piece == i)
            if len(here):
                along = length[here] - (until[i - 1] if i else 0)
                along = ends[i, 0] + np.sign(ends[i, 1] - ends[i, 0]) * along
                points[here] = spline.points(spline.parameter_at(along))
        return points

    def points(self, n=33):
        """n points [n, 2], equally spaced by arc length."""
        return self.at(np.linspace(0, 1, n))


@dataclasses.dataclass
class Line:
    """A separatrix: its first and last node, its kind (traced, merged, cut, extended) and its arcs in order, each with
    True if it is followed forwards."""
    origin: int
    end: int
    kind: str
    arcs: list

    def points(self, n=33):
        """Points along the line, n of each arc."""
        return np.concatenate([arc.points(n)[::1 if forwards else -1] for arc, forwards in self.arcs])


class ArcGraph:
    """`face`: Face; `nodes`: GraphNode; `arcs`: Arc. What a separatrix graph and a block layout have in common."""

    def __init__(self, content):
        self.face = Face(content["face"])
        origin = self.face.origin
        curves = self.face.curves + read_splines(content["splines"], origin)
        self.nodes = [GraphNode(i, np.asarray(r["position"], float) + origin, r["kind"], int(r["valence"]),
                                int(r["curve"]), float(r["t"])) for i, r in enumerate(records(content["nodes"]))]
        self.arcs = []
        for i, record in enumerate(records(content["arcs"])):
            followed = [int(p["curve"]) for p in record["pieces"]]
            pieces = [(curves[c], float(p["t0"]), float(p["t1"])) for c, p in zip(followed, record["pieces"])]
            names = list(dict.fromkeys(self.face.curve_names[c] for c in followed if c < len(self.face.curves)))
            self.arcs.append(Arc(i, record, pieces, names))


class SeparatrixGraph(ArcGraph, StageResult):
    """Also `lines`: the separatrices, Line; `certificate`: a dict, or None; `t_junctions`: numbers of nodes."""

    def __init__(self, content):
        super().__init__(content)
        self.lines = [Line(r["origin"], r["end"], r["kind"], self._followed(r)) for r in content["lines"]]
        self.certificate = content.get("certificate")
        self.t_junctions = list(content["t_junctions"])

    def summary(self):
        return f"{len(self.nodes)} nodes, {len(self.arcs)} arcs, {len(self.lines)} lines"

    def _followed(self, record):
        node, followed = record["origin"], []
        for number in record["arcs"]:
            arc = self.arcs[number]
            forwards = arc.start == node
            followed.append((arc, forwards))
            node = arc.end if forwards else arc.start
        return followed
