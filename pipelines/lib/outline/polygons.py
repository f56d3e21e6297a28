"""Distances, crossings and insides of polygons."""


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
    """Between two of the points, which are corners of their convex hull."""
    hull = convex_hull(points)
    return max((abs(a - b) for a in hull for b in hull), default=0.0)


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


def is_inside(z, polygon):
    """Whether a ray from z to the right crosses the polygon an odd number of times."""
    inside = False
    for a, b in zip(polygon, polygon[1:] + polygon[:1]):
        is_level = (a.imag > z.imag) != (b.imag > z.imag)
        if is_level and z.real < a.real + (z.imag - a.imag) / (b.imag - a.imag) * (b - a).real:
            inside = not inside
    return inside
