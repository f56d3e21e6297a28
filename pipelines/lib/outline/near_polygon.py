"""Curves along an open polygon of few points: they stay near it, and have a corner where it turns sharply."""
from outline import edges, polygons, splines
from outline.corners import turning_angle

# Degrees. A line that turns by more has a different number of blocks on its two sides: blocks have corners of about 90
# degrees, and two of them, 180 degrees, are nearest to an angle between 135 and 225 degrees.
SHARP = 45.0
# The greatest distance of the curve from a segment, in units of its length, or of twice that of a segment beside it if
# that is less. Where a polygon turns by 30 degrees at each point, its smooth curve is 0.07 lengths away.
NEAR = 0.1
SAMPLES = 8  # of each segment of the curve


def smooth_edges(points, name):
    """Lines and C2 cubics through all points, with corners between them."""
    corners = [i for i in range(1, len(points) - 1)
               if turning_angle(points[i] - points[i - 1], points[i + 1] - points[i]) > SHARP + 1e-6]
    result = []
    for a, b in zip([0] + corners, corners + [len(points) - 1]):
        run = with_middles(points[a : b + 1])
        result += edges.smooth_edges(run, [name] * len(run), [], is_periodic=False)
    return result


def with_middles(points):
    """The points, and middles of segments from which their spline is too far, again and again."""
    lengths = [abs(b - a) for a, b in zip(points, points[1:])]
    limits = [NEAR * min([length] + [2 * beside for beside in lengths[max(i - 1, 0) : i + 2]])
              for i, length in enumerate(lengths)]
    while len(points) > 2:
        is_far = [distance > limit for distance, limit in zip(distances(points), limits)]
        if not any(is_far):
            break
        divided = [[a, (a + b) / 2] if far else [a] for a, b, far in zip(points, points[1:], is_far)]
        limits = [limit for limit, far in zip(limits, is_far) for _ in range(1 + far)]
        points = [z for part in divided for z in part] + points[-1:]
    return points


def distances(points):
    """Of the spline from each segment of its polygon."""
    t = splines.chord_lengths(points)
    derivatives = splines.open_derivatives(t, points)
    result = []
    for i, (a, b) in enumerate(zip(points, points[1:])):
        step = t[i + 1] - t[i]
        poles = [a, a + step / 3 * derivatives[i], b - step / 3 * derivatives[i + 1], b]
        result.append(max(polygons.distance_to_segment(splines.cubic(poles, k / SAMPLES), a, b) for k in range(1, SAMPLES)))
    return result
