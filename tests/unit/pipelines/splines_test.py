import cmath
import math
import unittest

from outline import splines


def de_boor(poles, knots, t):
    """A cubic with simple inner knots at t, by de Boor's algorithm."""
    clamped = [knots[0]] * 3 + list(knots) + [knots[-1]] * 3
    span = max(k for k in range(3, len(poles)) if clamped[k] <= t)
    local = [poles[span - 3 + i] for i in range(4)]
    for level in range(1, 4):
        for i in range(3, level - 1, -1):
            left, right = clamped[span - 3 + i], clamped[span + 1 + i - level]
            local[i] = local[i - 1] + (t - left) / (right - left) * (local[i] - local[i - 1])
    return local[3]


class SplinesTest(unittest.TestCase):
    def test_parameters_are_lengths_of_the_polygon(self):
        self.assertEqual(splines.chord_lengths([0, 3, 3 + 4j]), [0, 3, 7])

    def test_tridiagonal_systems(self):
        lower, middle, upper, x = [0, 1, 2], [4, 5, 6], [1, 2, 0], [1, 2j, 3]
        right = [4 * 1 + 2j, 1 + 5 * 2j + 2 * 3, 2 * 2j + 6 * 3]
        for found, exact in zip(splines.solve_tridiagonal(lower, middle, upper, right), x):
            self.assertAlmostEqual(found, exact, 14)

    def test_a_cubic_is_reproduced_and_three_points_give_the_parabola(self):
        t = [0, 1, 1.5, 3, 4]
        for found, s in zip(splines.open_derivatives(t, [s**3 - 2 * s + 1j * s * s for s in t]), t):
            self.assertAlmostEqual(found, 3 * s * s - 2 + 2j * s, 12)
        t = [0, 1, 3]
        for found, s in zip(splines.open_derivatives(t, [s * s for s in t]), t):
            self.assertAlmostEqual(found, 2 * s, 14)

    def test_the_spline_passes_through_its_points(self):
        t, z = [0, 1, 1.5, 3, 4], [0, 1 + 1j, 2, 3 - 1j, 2j]
        poles = splines.poles(t, z, splines.open_derivatives(t, z))
        self.assertEqual(len(poles), len(t) + 2)
        for s, point in zip(t, z):
            self.assertAlmostEqual(de_boor(poles, t, s), point, 13)

    def test_the_periodic_spline_of_a_circle_has_fourth_order_and_no_seam(self):
        errors = []
        for n in (16, 32):
            z = [cmath.rect(1, 2 * math.pi * k / n) for k in range(n)] + [1]
            t = splines.chord_lengths(z)
            derivatives = splines.periodic_derivatives(t, z)
            for found, point in zip(derivatives, z):  # by symmetry the same at every point
                self.assertAlmostEqual(found / point, derivatives[0], 12)
            poles = splines.poles(t, z, derivatives)
            errors.append(max(abs(abs(de_boor(poles, t, (a + b) / 2)) - 1) for a, b in zip(t, t[1:])))
        self.assertLess(errors[1], errors[0] / 14)
        self.assertLess(errors[1], 1e-5)
