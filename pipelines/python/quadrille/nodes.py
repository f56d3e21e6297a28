"""Irregular nodes and corner valences (formats/critical-points.md)."""
import dataclasses

import numpy as np

from .stage_result import StageResult


@dataclasses.dataclass
class Node:
    """An irregular node inside the face.

    `valence`: blocks around it; `index`: 4 - valence; `jacobian`: derivatives of the field [2, 2], zeros where the node
    is no zero of it; `error`: error bar of the position, 0 where it is unknown; `source`: where the node comes from.
    """
    position: np.ndarray
    valence: int
    index: int
    elem: int
    xi: np.ndarray
    jacobian: np.ndarray
    error: float
    source: str


@dataclasses.dataclass
class Corner:
    """A corner of the face: its joint, the curves that end and start there, and the number of blocks in its sector."""
    position: np.ndarray
    joint: int
    curves: tuple
    angle_degrees: float
    valence: int
    source: str


@dataclasses.dataclass
class BoundaryNode:
    """An irregular node on a curve of the face, at its parameter t."""
    position: np.ndarray
    curve: int
    t: float
    valence: int
    source: str


class CriticalPoints(StageResult):
    """`nodes`: Node; `corners`: Corner; `boundary_nodes`: BoundaryNode; `form`: "harmonic" or "phase"; `index_sum`: the
    sum of (4 - V) over nodes and (2 - V) over corners and boundary nodes; `changes`, `zeros`, `certificate`: as in the
    file."""

    def __init__(self, content):
        origin = np.asarray(content["origin"], float)
        self.form = content.get("form", "harmonic")
        self.nodes = [_node(p, origin) for p in content["critical_points"]]
        self.zeros = [_node(p, origin) for p in content.get("zeros", [])]
        self.corners = [Corner(np.asarray(c["position"]) + origin, c["joint"], tuple(c["curves"]), c["angle_degrees"],
                               c["valence"], c.get("source", "angle")) for c in content["corners"]]
        self.boundary_nodes = [BoundaryNode(np.asarray(b["position"]) + origin, b["curve"], b["t"], b["valence"],
                                            b.get("source", "feature")) for b in content.get("boundary_nodes", [])]
        self.index_sum = sum(n.index for n in self.nodes) + \
            sum(2 - c.valence for c in [*self.corners, *self.boundary_nodes])
        self.expected_index_sum = content["index_sum"]["expected"]
        self.changes = content.get("changes", [])
        self.certificate = content.get("certificate")

    def summary(self):
        valences = ", ".join(str(valence) for valence in sorted(self.valences))
        of_valence = f" of valence {valences}" if valences else ""
        return f"{len(self.nodes)} irregular nodes{of_valence}, {len(self.corners)} corners"

    @property
    def positions(self):
        """Positions of the nodes inside [n, 2]."""
        return np.array([node.position for node in self.nodes]).reshape(-1, 2)

    @property
    def valences(self):
        """Their valences [n]."""
        return np.array([node.valence for node in self.nodes], int)


def _node(point, origin):
    has_jacobian = "jacobian" in point
    return Node(np.asarray(point["position"], float) + origin, point["valence"],
                point.get("index", 4 - point["valence"]), point.get("elem", 0), np.array(point.get("xi", [0, 0]), float),
                np.array(point.get("jacobian", [0, 0, 0, 0]), float).reshape(2, 2), point.get("error", 0.0),
                point.get("source", "zero" if has_jacobian else "hand"))
