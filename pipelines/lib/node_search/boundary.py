"""Points along the boundary of a face (formats/cad-face.md)."""
import bisect

POINTS_PER_SPAN = 64  # dense enough to find the nearest boundary


def nurbs_point(curve, t):
    """By de Boor's algorithm."""
    degree, knots = curve["degree"], curve["knots"]
    span = min(max(bisect.bisect_right(knots, t) - 1, degree), len(curve["poles"]) - 1)
    active = range(span - degree, span + 1)
    local = [(complex(*curve["poles"][i]) * curve["weights"][i], curve["weights"][i]) for i in active]
    for level in range(1, degree + 1):
        for i in range(degree, level - 1, -1):
            left, right = knots[span - degree + i], knots[span + 1 + i - level]
            fraction = (t - left) / (right - left)
            local[i] = tuple((1 - fraction) * a + fraction * b for a, b in zip(local[i - 1], local[i]))
    return local[degree][0] / local[degree][1]


def curve_points(curve):
    breaks = sorted(set(curve["knots"][curve["degree"] : len(curve["poles"]) + 1]))
    fractions = [k / POINTS_PER_SPAN for k in range(POINTS_PER_SPAN)]
    return [nurbs_point(curve, a + (b - a) * fraction) for a, b in zip(breaks, breaks[1:]) for fraction in fractions]


def boundary_points(face):
    return [point for curve in face["curves"] for point in curve_points(curve)]
