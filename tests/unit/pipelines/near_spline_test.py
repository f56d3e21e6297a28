import cmath
import math
import unittest

from outline import near_spline


class NearSplineTest(unittest.TestCase):
    def test_a_spacing_is_the_length_of_a_segment_unless_one_beside_it_is_far_shorter(self):
        self.assertEqual(near_spline.spacings([0, 1, 4, 5], False), [1, 2, 1])
        self.assertEqual(near_spline.spacings([0, 4, 4 + 1j, 0], True)[0], 2)

    def test_an_arc_is_within_its_limits_and_a_corner_beside_a_straight_line_is_not(self):
        arc = [cmath.rect(1, k * math.pi / 10) for k in range(11)]
        self.assertFalse(any(near_spline.far_segments(arc, near_spline.arc_limits(arc, False), False)))
        bent = [complex(k) for k in range(-8, 1)] + [complex(k, k) for k in range(1, 9)]
        limits = near_spline.arc_limits(bent, False)
        self.assertTrue(any(near_spline.far_segments(bent, limits, False)))
        points, positions = near_spline.with_middles(bent, limits, False)
        self.assertEqual([points[k] for k in positions], bent)
        fine = [limits[next(i for i, k in enumerate(positions[1:]) if k > j)] for j in range(len(points) - 1)]
        self.assertFalse(any(near_spline.far_segments(points, fine, False)))

    def test_closed_curves(self):
        circle = [cmath.rect(1, k * math.pi / 4) for k in range(8)] + [1]
        limits = near_spline.arc_limits(circle, True)
        self.assertAlmostEqual(limits[0], limits[-1])
        self.assertEqual(near_spline.with_middles(circle, limits, True), (circle, list(range(9))))
        self.assertGreater(len(near_spline.with_middles(circle, [0.01] * 8, True)[0]), 9)

    def test_the_distance_from_the_segment(self):
        poles = [0, 1 + 1j, 2 + 1j, 3]
        self.assertAlmostEqual(near_spline.distance_beyond(poles, 0), 0.75)
        self.assertEqual(near_spline.distance_beyond(poles, 2), 1)  # a bound is enough


if __name__ == "__main__":
    unittest.main()
