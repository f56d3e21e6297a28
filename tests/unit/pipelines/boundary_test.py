import unittest

from node_search import boundary

LINE = {"degree": 1, "knots": [0, 0, 2, 2], "poles": [[0, 0], [4, 2]], "weights": [1, 1]}
QUARTER = {"degree": 2, "knots": [0, 0, 0, 1, 1, 1], "poles": [[1, 0], [1, 1], [0, 1]], "weights": [1, 0.5**0.5, 1]}
BROKEN = {"degree": 1, "knots": [0, 0, 1, 3, 3], "poles": [[0, 0], [1, 0], [1, 2]], "weights": [1, 1, 1]}


class BoundaryTest(unittest.TestCase):
    def test_points_of_a_line_a_circle_and_a_curve_with_an_inner_knot(self):
        self.assertEqual(boundary.nurbs_point(LINE, 1), 2 + 1j)
        for k in range(9):
            self.assertAlmostEqual(abs(boundary.nurbs_point(QUARTER, k / 8)), 1, 14)
        self.assertEqual([boundary.nurbs_point(BROKEN, t) for t in (0, 1, 2, 3)], [0, 1, 1 + 1j, 1 + 2j])

    def test_each_span_between_knots_has_its_points(self):
        points = boundary.boundary_points({"curves": [LINE, BROKEN]})
        self.assertEqual(len(points), 3 * boundary.POINTS_PER_SPAN)
        self.assertEqual(points[:: boundary.POINTS_PER_SPAN], [0, 0, 1])
