import math
import unittest

from outline import near_polygon, polygons, splines
from outline.edges import Line, Spline

STEP = [1, 5, 5 + 1j, 12 + 1j, 21 + 1j]
BEND = [1, 3, 6 + 3j, 21 + 3j]


def samples(edge, count=20):
    if isinstance(edge, Line):
        return [edge.start, edge.end]
    t = edge.knots
    points = []
    for u in (t[0] + (t[-1] - t[0]) * k / (count * len(t)) for k in range(count * len(t) + 1)):
        points.append(de_boor(edge.poles, [t[0]] * 3 + t + [t[-1]] * 3, u))
    return points


def de_boor(poles, knots, u):
    k = max(i for i in range(3, len(poles)) if knots[i] <= u)
    d = poles[k - 3 : k + 1]
    for r in range(1, 4):
        for j in range(3, r - 1, -1):
            low, high = knots[j + k - 3], knots[j + 1 + k - r]
            d[j] = d[j - 1] + (u - low) / (high - low) * (d[j] - d[j - 1])
    return d[3]


def largest_distance(edges, points):
    """Of the edges from the polygon."""
    return max(min(polygons.distance_to_segment(z, a, b) for a, b in zip(points, points[1:]))
               for edge in edges for z in samples(edge))


class NearPolygonTest(unittest.TestCase):
    def test_a_sharp_turn_is_a_corner(self):
        edges = near_polygon.smooth_edges(STEP, "wake")
        self.assertEqual([type(edge) for edge in edges], [Line, Line, Spline])
        self.assertEqual([edge.start for edge in edges] + [edges[-1].end], [1, 5, 5 + 1j, 21 + 1j])
        self.assertLess(largest_distance(edges, STEP), 1e-12)

    def test_a_turn_of_45_degrees_is_none_and_the_curve_stays_near(self):
        for points in (BEND, BEND[::-1], [1j * z for z in BEND]):
            (edge,) = near_polygon.smooth_edges(points, "wake")
            self.assertEqual((edge.start, edge.end, edge.name), (points[0], points[-1], "wake"))
            self.assertLess(largest_distance([edge], points), 0.1 * 2 * abs(3 + 3j))
            self.assertTrue(all(min(abs(p - z) for z in samples(edge, 400)) < 0.02 for p in points))

    def test_points_of_a_smooth_curve_stay_those_of_its_spline(self):
        arc = [complex(math.cos(a), math.sin(a)) for a in (0.5 * k for k in range(7))]
        (edge,) = near_polygon.smooth_edges(arc, "wake")
        t = splines.chord_lengths(arc)
        self.assertEqual((edge.knots, edge.poles), (t, splines.poles(t, arc, splines.open_derivatives(t, arc))))
        self.assertEqual(near_polygon.smooth_edges([0, 2], "wake"), [Line(0, 2, "wake")])


if __name__ == "__main__":
    unittest.main()
