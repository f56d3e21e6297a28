"""Curves along an open polygon of few points: they stay near it, and have a corner where it turns sharply."""
from outline import corners, edges, near_spline

# Degrees. A line that turns by more has a different number of blocks on its two sides: blocks have corners of about 90
# degrees, and two of them, 180 degrees, are nearest to an angle between 135 and 225 degrees.
SHARP = 45.0
# The greatest distance of the curve from a segment, in spacings. Where a polygon turns by 30 degrees at each point, its
# smooth curve is 0.07 lengths away.
NEAR = 0.1


def smooth_edges(points, name):
    """Lines and C2 cubics through all points, with corners between them."""
    turns = [i for i in range(1, len(points) - 1)
             if corners.turning_angle(points[i] - points[i - 1], points[i + 1] - points[i]) > SHARP + 1e-6]
    result = []
    for a, b in zip([0] + turns, turns + [len(points) - 1]):
        run = points[a : b + 1]
        limits = [NEAR * spacing for spacing in near_spline.spacings(run, is_periodic=False)]
        run, _ = near_spline.with_middles(run, limits, is_periodic=False)
        result += edges.smooth_edges(run, [name] * len(run), [], is_periodic=False)
    return result
