import cmath
import math
import unittest

from outline import smoothing


def roughness(points):
    return sum(abs(a - 2 * b + c) ** 2 for a, b, c in zip(points, points[1:], points[2:]))


class SmoothingTest(unittest.TestCase):
    def test_noise_is_smoothed_within_the_tolerance_and_ends_stay(self):
        noisy = [complex(k, 0.1 * (-1) ** k) for k in range(30)]
        smooth = smoothing.smoothed(noisy, 0.15, False)
        self.assertEqual((smooth[0], smooth[-1]), (noisy[0], noisy[-1]))
        self.assertTrue(0.05 < max(abs(a - b) for a, b in zip(noisy, smooth)) <= 0.15)
        self.assertLess(roughness(smooth), 0.01 * roughness(noisy))
        self.assertEqual(smoothing.smoothed(noisy, 0.15, False, fixed=[7])[7], noisy[7])

    def test_points_of_a_line_stay(self):
        line = [complex(k * k, 2 * k * k) for k in range(9)]
        for a, b in zip(line, smoothing.smoothed(line, 1, False)):
            self.assertAlmostEqual(a, b, 9)

    def test_a_closed_curve_has_no_seam(self):
        noisy = [cmath.rect(1 + 0.02 * (-1) ** k, k * math.pi / 20) for k in range(40)]
        smooth = smoothing.smoothed(noisy + noisy[:1], 0.03, True)
        self.assertEqual((len(smooth), smooth[0]), (41, smooth[-1]))
        radii = [abs(z) for z in smooth]
        self.assertLess(max(radii) - min(radii), 0.01)

    def test_the_band_solver(self):
        middle, near, far, x = [4, 5, 6, 7], [1, 2, 1], [0.5, 1], [1, 2j, 3, -1]
        rows = [[4, 1, 0.5, 0], [1, 5, 2, 1], [0.5, 2, 6, 1], [0, 1, 1, 7]]
        right = [sum(a * b for a, b in zip(row, x)) for row in rows]
        for found, exact in zip(smoothing.solve_band(middle, near, far, right), x):
            self.assertAlmostEqual(found, exact, 12)


if __name__ == "__main__":
    unittest.main()
