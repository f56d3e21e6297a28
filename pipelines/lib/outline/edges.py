"""Edges of a face: lines, arcs and splines between two points, each with a name."""
import math
from dataclasses import dataclass, field, replace

from outline import near_spline, polygons, smoothing, splines
from outline.fit import Fit
from outline.simplify import SMALL

FAR_FIELDS = ("circle", "box", "cgrid")


@dataclass(frozen=True)
class Line:
    start: complex
    end: complex
    name: str


@dataclass(frozen=True)
class Arc:
    """Counter-clockwise; the whole circle if start and end are one point."""

    centre: complex
    radius: float
    start: complex
    end: complex
    name: str


@dataclass(frozen=True)
class Spline:
    """A clamped cubic with simple inner knots."""

    poles: list
    knots: list
    name: str

    @property
    def start(self):
        return self.poles[0]

    @property
    def end(self):
        return self.poles[-1]


def smooth_edges(points, names, joints, is_periodic):
    """Along the points between two corners: a line if there are two, else parts of one cubic that end at `joints`."""
    if len(points) == 2:
        return [Line(*points, names[0])]
    t = splines.chord_lengths(points)
    derivatives = (splines.periodic_derivatives if is_periodic else splines.open_derivatives)(t, points)
    ends = [0] + sorted(joints) + [len(points) - 1]
    parts = [slice(a, b + 1) for a, b in zip(ends, ends[1:])]
    return [Spline(splines.poles(t[part], points[part], derivatives[part]), t[part], names[part.start]) for part in parts]


@dataclass(frozen=True)
class Nearness:
    """How near edges stay to the points that they are made from; lengths in the units of the points."""

    smoothing: float = 0.0  # curves stay within this of the polygon, and points move; 0, and in small loops: none does
    limit: float = math.inf  # the greatest distance of a curve from the polygon, beside near_spline.arc_limits
    fit: Fit = field(default_factory=Fit)  # to which the distances are added


def near_edges(points, names, joints, is_periodic, nearness):
    """The same, which stay near the polygon. `names`: of the segments."""
    if len(points) == 2:
        return [Line(*points, names[0])]
    if nearness.smoothing > 0:
        moves = smoothing.SHARE * nearness.smoothing
        given, points = points, smoothing.smoothed(points, moves, is_periodic, fixed=joints)
        nearness.fit.add_moves(given, points)
        limits = [nearness.smoothing - moves] * (len(points) - 1)
    else:
        limits = [min(limit, nearness.limit) for limit in near_spline.arc_limits(points, is_periodic)]
    fine, positions = near_spline.with_middles(points, limits, is_periodic)
    nearness.fit.add_curve(fine, is_periodic)
    fine_names = [name for name, a, b in zip(names, positions, positions[1:]) for _ in range(b - a)]
    return smooth_edges(fine, fine_names, [positions[k] for k in joints], is_periodic)


def straight_edges(loop):
    ends = loop.points[1:] + loop.points[:1]
    return [Line(a, b, name) for a, b, name in zip(loop.points, ends, loop.names)]


def loop_edges(loop, nearness=None):
    """Smooth edges from corner to corner of a loop; without corners one periodic curve from its first point."""
    count, nearness = len(loop.points), nearness or Nearness()
    if polygons.box_size(loop.points) <= SMALL * nearness.smoothing:
        nearness = replace(nearness, smoothing=0.0)
    corners, edges = sorted(loop.corners) or [0], []
    for a, b in zip(corners, corners[1:] + [corners[0] + count]):
        run = [i % count for i in range(a, b + 1)]
        joints = [k for k, i in enumerate(run) if i in loop.joints and 0 < k < len(run) - 1]
        points, names = [loop.points[i] for i in run], [loop.names[i] for i in run]
        edges += near_edges(points, names, joints, not loop.corners, nearness)
    return edges


def far_field_edges(kind, radius, middle, tail):
    """A circle or a box (from -radius to radius) around `middle`, or around `tail` a half circle to the left and a
    rectangle of the length `radius` to the right."""
    name = "farfield"
    if kind == "circle":
        return [Arc(middle, radius, middle + radius, middle + radius, name)]
    around = middle if kind == "box" else tail
    corners = [around + complex(x, y) * radius for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    if kind == "box":
        return [Line(a, b, name) for a, b in zip(corners, corners[1:] + corners[:1])]
    low, high = tail - 1j * radius, tail + 1j * radius
    sides = [Line(low, corners[1], name), Line(corners[1], corners[2], name), Line(corners[2], high, name)]
    return sides + [Arc(tail, radius, high, low, name)]
