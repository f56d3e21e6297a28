"""Curves through points that stay near their polygon."""
import math

from outline import corners, polygons, splines

SAMPLES = 8  # of each segment of the curve
# The greatest distance of a curve from a segment, in units of its length, or of twice that of a segment beside it if that
# is less; beside the height of the arcs between the points.
NEAR = 0.01
MOST_DIVISIONS = 30  # in halves of a segment


def spacings(points, is_periodic):
    """Of each segment its length, or twice that of a segment beside it if that is less."""
    lengths = [abs(b - a) for a, b in zip(points, points[1:])]
    around = lengths[-1:] + lengths + lengths[:1] if is_periodic else [math.inf] + lengths + [math.inf]
    return [min(length, 2 * around[i], 2 * around[i + 2]) for i, length in enumerate(lengths)]


def arc_limits(points, is_periodic):
    """How far the curve through the points may be from each segment: NEAR spacings, and twice the height of an arc that
    turns as the polygon does at the ends of the segment (spacing times turn over 8, for even points)."""
    steps = [b - a for a, b in zip(points, points[1:])]
    turns = [math.radians(corners.turning_angle(a, b)) for a, b in zip(steps, steps[1:])]
    if is_periodic:
        seam = math.radians(corners.turning_angle(steps[-1], steps[0]))
        turns = [seam] + turns + [seam]
    else:
        turns = turns[:1] + turns + turns[-1:]
    return [spacing * (NEAR + (before + behind) / 8)
            for spacing, before, behind in zip(spacings(points, is_periodic), turns, turns[1:])]


def with_middles(points, limits, is_periodic, ends=(None, None)):
    """(points, positions of the given ones among them): the points, and middles of segments from which their spline is
    farther than the limit of the segment, again and again. `ends`: as those of splines.open_derivatives."""
    positions = list(range(len(points)))
    for _ in range(MOST_DIVISIONS if len(points) > 2 else 0):
        is_far = far_segments(points, limits, is_periodic, ends)
        if not any(is_far):
            break
        moved, count = [], 0
        for far in is_far + [False]:
            moved.append(count)
            count += 1 + far
        positions = [moved[i] for i in positions]
        divided = [[a, (a + b) / 2] if far else [a] for a, b, far in zip(points, points[1:], is_far)]
        limits = [limit for limit, far in zip(limits, is_far) for _ in range(1 + far)]
        points = [z for part in divided for z in part] + points[-1:]
    return points, positions


def derivatives(t, points, is_periodic, ends=(None, None)):
    return splines.periodic_derivatives(t, points) if is_periodic else splines.open_derivatives(t, points, *ends)


def spline_parts(points, is_periodic, ends=(None, None)):
    """The four Bezier poles of each cubic of the spline through the points."""
    t = splines.chord_lengths(points)
    slopes = derivatives(t, points, is_periodic, ends)
    for i, (a, b) in enumerate(zip(points, points[1:])):
        third = (t[i + 1] - t[i]) / 3
        yield [a, a + third * slopes[i], b - third * slopes[i + 1], b]


def far_segments(points, limits, is_periodic, ends=(None, None)):
    """Which segments the spline through the points leaves by more than their limits."""
    return [distance_beyond(poles, limit) > limit for poles, limit in zip(spline_parts(points, is_periodic, ends), limits)]


def distance_beyond(poles, limit):
    """The greatest distance of a cubic from the segment between its ends; a bound of it where that is below the limit."""
    bound = max(polygons.distance_to_segment(pole, poles[0], poles[3]) for pole in poles[1:3])
    if bound <= limit:
        return bound
    points = (splines.cubic(poles, k / SAMPLES) for k in range(1, SAMPLES))
    return max(polygons.distance_to_segment(z, poles[0], poles[3]) for z in points)
