import unittest

import numpy as np

from quadrille.face import Spline

HALF = np.sqrt(0.5)


def quarter_circle():
    return Spline(2, [0, 0, 0, 1, 1, 1], [[1, 0], [1, 1], [0, 1]], [1, HALF, 1])


class SplineTest(unittest.TestCase):
    def test_a_quarter_circle(self):
        points, slopes = quarter_circle().sample(np.linspace(0, 1, 9))
        np.testing.assert_allclose(np.linalg.norm(points, axis=1), 1)
        np.testing.assert_allclose(np.sum(points * slopes, axis=1), 0, atol=1e-14)

    def test_length_and_its_inverse(self):
        circle = quarter_circle()
        np.testing.assert_allclose(circle.length_to(1), np.pi / 2, rtol=1e-13)
        lengths = np.linspace(0, np.pi / 2, 11)
        points = circle.points(circle.parameter_at(lengths))
        np.testing.assert_allclose(np.arctan2(points[:, 1], points[:, 0]), lengths, atol=1e-12)

    def test_inner_knots_and_derivatives(self):
        spline = Spline(3, [0, 0, 0, 0, 0.4, 0.7, 0.7, 1, 1, 1, 1],
                        [[0, 0], [1, 2], [2, 0], [3, 1], [4, 0], [5, 2], [6, 0]], [1, 2, 1, 1, 0.5, 1, 1])
        t, step = np.array([0.1, 0.4, 0.65, 0.9]), 1e-6
        difference = (spline.points(t + step) - spline.points(t - step)) / (2 * step)
        np.testing.assert_allclose(spline.derivatives(t), difference, atol=1e-4)
        np.testing.assert_array_equal(spline.points([0, 1]), [[0, 0], [6, 0]])


if __name__ == "__main__":
    unittest.main()
