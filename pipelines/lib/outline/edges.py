"""Edges of a face: lines, arcs and splines between two points, each with a name."""
import cmath
import math
from dataclasses import dataclass, field, replace

from outline import near_spline, polygons, smoothing, splines
from outline.fit import Fit
from outline.simplify import SMALL

LEAST_ANGLE = 30.0  # degrees: corners of the polygon that are sharper may become cusps
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
class EllipticArc:
    """The same of an ellipse: its half axes are `major`, a vector, and the length `minor`."""

    centre: complex
    major: complex
    minor: float
    start: complex
    end: complex
    name: str


@dataclass(frozen=True)
class Spline:
    """A clamped B-spline, a cubic with simple inner knots unless stated otherwise. `knots`: each once; `weights`: of a
    rational one."""

    poles: list
    knots: list
    name: str
    degree: int = 3
    multiplicities: tuple = ()
    weights: tuple = ()

    @property
    def start(self):
        return self.poles[0]

    @property
    def end(self):
        return self.poles[-1]


def smooth_edges(points, names, joints, is_periodic, ends=(None, None)):
    """Along the points between two corners: a line if there are two, else parts of one cubic that end at `joints`. `ends`:
    its derivatives there, unit vectors, or None where they are free."""
    if len(points) == 2:
        return [Line(*points, names[0])]
    t = splines.chord_lengths(points)
    derivatives = near_spline.derivatives(t, points, is_periodic, ends)
    parts = [slice(a, b + 1) for a, b in stretches([0] + sorted(joints) + [len(points) - 1])]
    return [Spline(splines.poles(t[part], points[part], derivatives[part]), t[part], names[part.start]) for part in parts]


def stretches(positions):
    return list(zip(positions, positions[1:]))


@dataclass(frozen=True)
class Nearness:
    """How near edges stay to the points that they are made from; lengths in the units of the points."""

    smoothing: float = 0.0  # curves stay within this of the polygon, and points move; 0, and in small loops: none does
    limit: float = math.inf  # the greatest distance of a curve from the polygon, beside near_spline.arc_limits
    fit: Fit = field(default_factory=Fit)  # to which the distances are added


def near_edges(points, names, joints, is_periodic, nearness, ends=(None, None)):
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
    fine, positions = near_spline.with_middles(points, limits, is_periodic, ends)
    nearness.fit.add_curve(fine, is_periodic, ends)
    fine_names = [name for name, (a, b) in zip(names, stretches(positions)) for _ in range(b - a)]
    return smooth_edges(fine, fine_names, [positions[k] for k in joints], is_periodic, ends)


def turn_of_curve(loop, corner, step):
    """The angle from the polygon's first segment to the curve that starts at a corner, forwards (step 1) or backwards (-1):
    that of a parabola through three points, 0 of a line."""
    count = len(loop.points)
    first, second = (corner + step) % count, (corner + 2 * step) % count
    segments = (corner, first) if step > 0 else (first, second)
    if first in loop.corners or any(segment in loop.walls for segment in segments):
        return 0.0
    points = [loop.points[corner], loop.points[first], loop.points[second]]
    start = splines.open_derivatives(splines.chord_lengths(points), points)[0]
    return cmath.phase(start / (points[1] - points[0]))


def is_sharpened(loop, corner):
    """Whether free curves would take away more than half of the polygon's angle at a corner. Cusps may be meant."""
    points = loop.points
    back, out = points[corner - 1] - points[corner], points[(corner + 1) % len(points)] - points[corner]
    angle = cmath.phase(out / back)
    turned = math.copysign(1.0, angle) * (turn_of_curve(loop, corner, 1) - turn_of_curve(loop, corner, -1))
    return abs(angle) > math.radians(LEAST_ANGLE) and abs(angle) + turned < abs(angle) / 2


def held_direction(loop, corner, step):
    """Of the polygon's segment behind (step 1) or before a corner, where a curve must have it; None: nowhere."""
    if corner not in loop.corners or not is_sharpened(loop, corner):
        return None
    along = step * (loop.points[(corner + step) % len(loop.points)] - loop.points[corner])
    return along / abs(along)


def run_edges(points, names, joints, walls, nearness, corner_ends=(None, None)):
    """Edges from corner to corner: lines along walls (as those of a Loop), and curves between, which begin and end in the
    directions of the walls beside them. `corner_ends`: directions at both corners, None where they are free."""
    last = len(points) - 1
    breaks = [0] + [k for k in range(1, last) if walls.get(k) != walls.get(k - 1)] + [last]

    def direction(k):
        """Of the wall that the segment k is on, if it is on one."""
        step = points[k % last + 1] - points[k % last]
        return step / abs(step) if k in walls else None

    edges = []
    for a, b in stretches(breaks):
        if a in walls:
            edges.append(Line(points[a], points[b], names[a]))
        else:
            inner = [k - a for k in joints if a < k < b]
            begin = corner_ends[0] if a == 0 else None
            end = corner_ends[1] if b == last else None
            ends = begin or direction(a - 1), end or direction(b)
            edges += near_edges(points[a : b + 1], names[a:b], inner, False, nearness, ends)
    return edges


def straight_edges(loop):
    ends = loop.points[1:] + loop.points[:1]
    return [Line(a, b, name) for a, b, name in zip(loop.points, ends, loop.names)]


def loop_edges(loop, nearness=None):
    """Smooth edges from corner to corner of a loop; without corners one periodic curve from its first point."""
    count, nearness = len(loop.points), nearness or Nearness()
    if polygons.box_size(loop.points) <= SMALL * nearness.smoothing:
        nearness = replace(nearness, smoothing=0.0)
    begins = [i for i in loop.walls if loop.walls.get((i - 1) % count) != loop.walls[i]]
    ends = sorted(loop.corners) or sorted(begins)[:1] or [0]
    edges = []
    for a, b in stretches(ends + [ends[0] + count]):
        run = [i % count for i in range(a, b + 1)]
        joints = [k for k, i in enumerate(run) if i in loop.joints and 0 < k < len(run) - 1]
        points, names = [loop.points[i] for i in run], [loop.names[i] for i in run]
        # Without corners, the wall at the beginning is also the one behind the end.
        walls = {k: loop.walls[i] for k, i in enumerate(run[:-1] if loop.corners else run) if i in loop.walls}
        if walls or loop.corners:
            corner_ends = held_direction(loop, run[0], 1), held_direction(loop, run[-1], -1)
            edges += run_edges(points, names, joints, walls, nearness, corner_ends)
        else:
            edges += near_edges(points, names, joints, True, nearness)
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
