import cmath
import math
import unittest

from drawing import curves
from drawing.curves import Affine, Segment, Spline
from drawing_samples import QUARTER

TILT = curves.affine_of(2, 0.5, -0.25, -1, 3, 4)
PERIODIC = Spline(3, tuple(range(12)), (0, 2, 2 + 2j, 2j, -1 + 1j, 0, 2, 2 + 2j))


class CurvesTest(unittest.TestCase):
    def assert_same_curve(self, one, other, moved=lambda z: z):
        for i in range(9):
            t = [low + i / 8 * (high - low) for low, high in (one.range, other.range)]
            self.assertAlmostEqual(moved(one.at(t[0])), other.at(t[1]), 12)

    def test_affine_maps(self):
        self.assertAlmostEqual(TILT(1 + 2j), complex(2 + 1 + 3, -0.25 - 2 + 4))
        turn = Affine(1j, 0, 5)
        self.assertAlmostEqual(TILT.after(turn)(1 - 3j), TILT(turn(1 - 3j)))
        self.assertAlmostEqual(turn.after(TILT)(1 - 3j), turn(TILT(1 - 3j)))

    def test_affine_images_of_curves_are_curves_of_the_same_kind(self):
        for curve in (Segment(1, 2j), curves.circle(1 + 1j, 2, 0.5, 4), curves.ellipse(1, 2 + 1j, 0.5j, 1, 2), QUARTER, PERIODIC):
            self.assertIs(type(curve.mapped(TILT)), type(curve))
            self.assert_same_curve(curve, curve.mapped(TILT), TILT)

    def test_half_axes_of_an_image(self):
        major, minor = curves.circle(0, 1).mapped(curves.affine_of(1, 0, 0, 3)).half_axes
        self.assertAlmostEqual(abs(major.imag), 3)
        self.assertAlmostEqual(minor, 1)
        self.assertTrue(curves.circle(0, 2).mapped(Affine(0, 1j)).is_circle)
        self.assertFalse(curves.circle(0, 2).mapped(Affine(0, 1j)).is_left)

    def test_bulges(self):
        half = curves.bulged(1 + 0j, -1 + 0j, 1.0)
        self.assertAlmostEqual(half.at(sum(half.range) / 2), 1j)
        other = curves.bulged(1 + 0j, -1 + 0j, -1.0)
        self.assertAlmostEqual(other.at(sum(other.range) / 2), -1j)
        quarter = curves.bulged(2 + 0j, 2j, math.tan(math.pi / 8))
        self.assertAlmostEqual(quarter.centre, 0)
        for curve, ends in ((half, (1, -1)), (other, (1, -1)), (quarter, (2, 2j))):
            self.assertAlmostEqual(curve.start, ends[0])
            self.assertAlmostEqual(curve.end, ends[1])
        self.assertEqual(curves.bulged(0j, 1 + 0j, 0.0), Segment(0j, 1 + 0j))

    def test_a_rational_spline_is_a_circle(self):
        for i in range(5):
            self.assertAlmostEqual(abs(QUARTER.at(i / 4)), 1, 14)
        part = QUARTER.part(0.25, 0.75)
        self.assertAlmostEqual(part.at(0.5), cmath.exp(0.25j * math.pi), 14)
        self.assertEqual(part.poles[0], part.start)

    def test_parts_of_a_periodic_spline_are_clamped(self):
        self.assertEqual(PERIODIC.range, (3, 8))
        part = PERIODIC.part(3, 8)
        self.assertEqual(part.knots, (3,) * 4 + (4, 5, 6, 7) + (8,) * 4)
        self.assertAlmostEqual(part.poles[0], part.poles[-1])
        self.assert_same_curve(PERIODIC, part)
        self.assertEqual(PERIODIC.part(4 + 1e-12, 6).knots[0], 4)

    def test_smooth_parts_end_at_kinks(self):
        bent = Spline(2, (0, 0, 0, 1, 1, 2, 2, 2), (0, 1, 2, 2 + 1j, 2 + 2j))
        self.assertEqual([(part.start, part.end) for part in curves.smooth_parts(bent)], [(0, 2), (2, 2 + 2j)])
        line = Spline(1, (0, 0, 1, 2, 2), (0, 1, 1 + 1j))
        self.assertEqual(curves.smooth_parts(line), [Segment(0, 1), Segment(1, 1 + 1j)])

    def test_bends_bound_the_distance_from_the_chord(self):
        for curve in (curves.ellipse(0, 3, 1j, 0.2, 2), QUARTER, PERIODIC):
            for a, b, bend in curve.bends():
                chord = Segment(curve.at(a), curve.at(b))
                away = max(min(abs(curve.at(a + i / 8 * (b - a)) - chord.at(k / 100)) for k in range(101)) for i in range(9))
                self.assertLessEqual(away, bend * (b - a) ** 2 / 8 + 1e-3)


if __name__ == "__main__":
    unittest.main()
