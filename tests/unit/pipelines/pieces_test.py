import math
import unittest

from drawing import curves, pieces
from drawing.curves import Segment
from drawing_samples import QUARTER


def crossing(one, other, is_excepted=lambda z: False):
    return pieces.crossing(pieces.pieces(one), pieces.pieces(other), 1e-9, is_excepted)


class PiecesTest(unittest.TestCase):
    def test_the_nearest_point(self):
        self.assertAlmostEqual(pieces.parameter_near(Segment(0, 4 + 0j), 1 + 0.1j, 0.2), 0.25)
        self.assertIsNone(pieces.parameter_near(Segment(0, 4 + 0j), 1 + 0.3j, 0.2))
        self.assertAlmostEqual(pieces.parameter_near(curves.circle(0, 2), 2.001j, 0.01), math.pi / 2, 5)
        self.assertAlmostEqual(QUARTER.at(pieces.parameter_near(QUARTER, 0.6 + 0.8j, 1e-6)), 0.6 + 0.8j, 9)
        self.assertIsNone(pieces.parameter_near(QUARTER, 0.61 + 0.8j, 1e-6))

    def test_boxes_contain_the_curve_and_little_more(self):
        low, high = pieces.box(curves.circle(1 + 1j, 2))
        self.assertTrue(-1.5 < low.real <= -1 and -1.5 < low.imag <= -1 and 3 <= high.real < 3.5 and 3 <= high.imag < 3.5)
        self.assertEqual(pieces.box(Segment(1, 2j), 0.5), (-0.5 - 0.5j, 1.5 + 2.5j))
        self.assertEqual(pieces.size(Segment(3, 4j)), 5)

    def test_rays(self):
        for z, is_inside in ((0j, True), (0.99j, True), (1.01j, False), (-2 + 0j, False), (0.6 + 0.79j, True)):
            count = sum(pieces.is_crossed_by_ray(piece, z) for piece in pieces.pieces(curves.circle(0, 1)))
            self.assertEqual(count % 2 == 1, is_inside, z)

    def test_crossings(self):
        z = crossing(curves.circle(0, 1), Segment(0, 2 + 2j))
        self.assertAlmostEqual(z, (1 + 1j) / math.sqrt(2), 6)
        self.assertIsNone(crossing(curves.circle(0, 1), Segment(1.001 - 2j, 1.001 + 2j)))
        self.assertIsNone(crossing(curves.circle(0, 1), curves.circle(0.5, 0.4)))
        self.assertIsNone(crossing(QUARTER, Segment(0, 1 + 1j), lambda z: abs(z - (1 + 1j) / math.sqrt(2)) < 1e-3))
        self.assertIsNone(crossing(curves.circle(0, 1, 0, math.pi), Segment(1, 1 - 1j)))

    def test_areas(self):
        for curve, area in ((curves.circle(3 + 1j, 2), 4 * math.pi), (curves.ellipse(5, 3, -1j), -3 * math.pi)):
            self.assertAlmostEqual(sum(map(pieces.area_beside, pieces.pieces(curve))) / area, 1, 5)
        self.assertAlmostEqual(sum(map(pieces.area_beside, pieces.pieces(QUARTER))), math.pi / 4, 7)


if __name__ == "__main__":
    unittest.main()
