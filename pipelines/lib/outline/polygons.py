"""Distances, crossings and insides of polygons."""
import math


def cross(a, b):
    """a_x b_y - a_y b_x."""
    return (a.conjugate() * b).imag


def area(points):
    """Of a closed polygon; positive if it is counter-clockwise."""
    return sum(cross(a, b) for a, b in zip(points, points[1:] + points[:1])) / 2


def convex_hull(points):
    """Its corners, counter-clockwise (Andrew's monotone chain, O(n log n))."""
    ordered = sorted(set(points), key=lambda z: (z.real, z.imag))
    hull = []
    for sweep in (ordered, ordered[::-1]):
        chain = []
        for z in sweep:
            while len(chain) > 1 and cross(chain[-1] - chain[-2], z - chain[-1]) <= 0:
                chain.pop()
            chain.append(z)
        hull += chain[:-1]
    return hull


def largest_distance(points):
    """Between two of the points: corners of their convex hull with parallel tangents (rotating calipers)."""
    hull = convex_hull(points)
    count, k, largest = len(hull), 1, 0.0
    for i, a in enumerate(hull):
        along = hull[(i + 1) % count] - a
        while cross(along, hull[(k + 1) % count] - hull[k % count]) > 0:
            largest = max(largest, abs(hull[k % count] - a))
            k += 1
        largest = max(largest, abs(hull[k % count] - a), abs(hull[k % count] - hull[(i + 1) % count]))
    return largest


def box_size(points):
    """The diagonal of the box around them: at most 1.42 times the largest distance."""
    across, up = [z.real for z in points], [z.imag for z in points]
    return math.hypot(max(across) - min(across), max(up) - min(up))


def nearest_on_segment(p, a, b):
    """The point of the segment from a to b that is nearest to p."""
    fraction = ((p - a) * (b - a).conjugate()).real / abs(b - a) ** 2
    return a + (b - a) * min(max(fraction, 0.0), 1.0)


def distance_to_segment(p, a, b):
    return abs(p - nearest_on_segment(p, a, b))


def segments_meet(a, b, c, d, tolerance):
    """Whether the segments ab and cd cross, or come as near to each other as the tolerance."""
    if side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0:
        return True
    ends = distance_to_segment(a, c, d), distance_to_segment(b, c, d), distance_to_segment(c, a, b), distance_to_segment(d, a, b)
    return min(ends) <= tolerance


def side(a, b, p):
    """Positive if p lies to the left of the line from a to b."""
    return cross(b - a, p - a)


def is_right_of(z, a, b):
    """Whether the ray from z to the right crosses the segment from a to b."""
    return (a.imag > z.imag) != (b.imag > z.imag) and z.real < a.real + (z.imag - a.imag) / (b.imag - a.imag) * (b - a).real


def is_inside(z, polygon):
    """Whether a ray from z to the right crosses the polygon an odd number of times."""
    return sum(is_right_of(z, a, b) for a, b in zip(polygon, polygon[1:] + polygon[:1])) % 2 == 1
