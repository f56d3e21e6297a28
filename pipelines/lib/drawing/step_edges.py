"""Edges of a graph as those of a STEP file: arcs counter-clockwise, splines with their knots counted."""
from collections import Counter

from drawing.curves import Ellipse, Segment
from outline.edges import Arc, EllipticArc, Line, Spline
from outline.step_file import Reversed


class StepEdges:
    """One STEP edge for each edge, however many loops follow it."""

    def __init__(self):
        self.made = {}

    def loop(self, cycle):
        return [self.side(side) for side in cycle.sides]

    def side(self, side):
        edge, is_along = self.made.setdefault(side.edge, None) or self.make(side.edge)
        return edge if is_along == side.is_forward else Reversed(edge)

    def make(self, edge):
        self.made[edge] = step_edge(edge)
        return self.made[edge]


def step_edge(edge):
    """(the STEP edge, whether it runs in the direction of the edge)."""
    if isinstance(edge.curve, Segment):
        return Line(edge.start, edge.end, edge.name), True
    if isinstance(edge.curve, Ellipse):
        is_along = edge.curve.is_left
        return arc(edge.curve, *((edge.start, edge.end) if is_along else (edge.end, edge.start)), edge.name), is_along
    return spline(edge), True


def arc(curve, start, end, name):
    major, minor = curve.half_axes
    if curve.is_circle:
        return Arc(curve.centre, minor, start, end, name)
    return EllipticArc(curve.centre, major, minor, start, end, name)


def spline(edge):
    counts = Counter(edge.curve.knots)
    poles = [edge.start, *edge.curve.poles[1:-1], edge.end]
    return Spline(poles, list(counts), edge.name, edge.curve.degree, tuple(counts.values()), edge.curve.weights)
