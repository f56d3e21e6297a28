import unittest

import numpy as np

from quadrille import reference

RANDOM = np.random.default_rng(1)


class TriangleTest(unittest.TestCase):
    def test_the_modes_are_orthonormal(self):
        x, w = np.polynomial.legendre.leggauss(16)
        eta1, eta2 = [a.ravel() for a in np.meshgrid(x, x)]
        weights = np.outer(w, w).ravel() * (1 - eta2) / 2
        xi = np.column_stack([(1 + eta1) * (1 - eta2) / 2 - 1, eta2])
        modes = reference.tri_modes(12, xi)[0]
        np.testing.assert_allclose(modes * weights @ modes.T, np.eye(len(modes)), atol=1e-12)

    def test_a_mode_of_degree_d_is_among_those_of_its_degree(self):
        xi = np.column_stack([RANDOM.uniform(-1, 0, 40), RANDOM.uniform(-1, 0, 40)])
        modes = reference.tri_modes(5, xi)[0]
        for degree in range(6):
            powers = np.array([xi[:, 0] ** i * xi[:, 1] ** j for i in range(6) for j in range(degree + 1 - i)])
            fit = np.linalg.lstsq(powers.T, modes[:reference.num_modes(degree)].T, rcond=None)[0]
            np.testing.assert_allclose(powers.T @ fit, modes[:reference.num_modes(degree)].T, atol=1e-9)

    def test_derivatives_are_those_of_the_values(self):
        xi, step = np.array([[-0.3, -0.2], [0.1, -0.9], [-1.0, 1.0]]), 1e-6
        _, d1, d2 = reference.tri_modes(8, xi)
        for k, derivative in enumerate((d1, d2)):
            shift = step * np.eye(2)[k]
            difference = (reference.tri_modes(8, xi + shift)[0] - reference.tri_modes(8, xi - shift)[0]) / (2 * step)
            np.testing.assert_allclose(derivative, difference, rtol=1e-6, atol=1e-5)

    def test_nodes_and_fit_reproduce_polynomials(self):
        for order in (1, 2, 3, 8, 17):
            nodes = reference.tri_nodes(order)
            self.assertEqual(len(nodes), reference.num_modes(order))
            self.assertEqual(reference.order_of(len(nodes)), order)
            coefficients = reference.tri_fit(order) @ nodes
            xi = np.array([[-0.2, -0.5], [0.3, -0.7]])
            value, derivative = reference.sum_modes(np.repeat(coefficients[None], 2, axis=0), xi)
            np.testing.assert_allclose(value, xi, atol=1e-10)
            np.testing.assert_allclose(derivative, np.repeat(np.eye(2)[None], 2, axis=0), atol=1e-8)


class LineTest(unittest.TestCase):
    def test_gauss_lobatto_points(self):
        np.testing.assert_allclose(reference.gll_points(1), [-1, 1])
        np.testing.assert_allclose(reference.gll_points(4), [-1, -np.sqrt(3 / 7), 0, np.sqrt(3 / 7), 1], atol=1e-14)

    def test_lagrange_polynomials(self):
        nodes, x = reference.gll_points(6), np.linspace(-1, 1, 7)
        value, slope = reference.lagrange(nodes, x)
        np.testing.assert_allclose(value @ nodes ** 5, x ** 5, atol=1e-13)
        np.testing.assert_allclose(slope @ nodes ** 5, 5 * x ** 4, atol=1e-12)


if __name__ == "__main__":
    unittest.main()
