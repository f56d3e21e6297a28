"""Polynomials on the reference triangle, on [-1, 1], and their nodes (formats/field.md, formats/tri-mesh.md,
formats/quad-mesh.md). Everything works on arrays of points."""
import functools
import math

import numpy as np

# Warburton's blending parameter of the interior nodes of a triangle by order, 5/3 beyond (Warburton 2006).
BLEND = (0, 0, 0, 1.4152, 0.1001, 0.2751, 0.9800, 1.0999, 1.2832, 1.3648, 1.4773, 1.4959, 1.5743, 1.5770, 1.6223,
         1.6258)
TRIANGLE = np.array([[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0]])


def num_modes(order):
    """Number of modes of the triangle up to a degree."""
    return (order + 1) * (order + 2) // 2


def order_of(modes):
    """The degree whose number of modes is `modes`."""
    return int((math.isqrt(8 * modes + 1) - 3) // 2)


def tri_modes(order, xi):
    """Values and derivatives of the Dubiner modes at points xi [n, 2]: three arrays [modes, n].

    Mode (p, q) is c_pq A_p(xi) P_q^(2p+1, 0)(xi2) with A_p = P_p(eta1) ((1 - xi2) / 2)^p, a polynomial, and is number
    d (d + 1) / 2 + p with d = p + q.
    """
    s, h = xi[:, 0] + (1 + xi[:, 1]) / 2, (1 - xi[:, 1]) / 2
    shape = (num_modes(order), len(xi))
    value, d1, d2 = np.empty(shape), np.empty(shape), np.empty(shape)
    for p, (a, a1, a2) in enumerate(_collapsed_legendre(order, s, h)):
        for q, (b, b2) in enumerate(_jacobi(order - p, 2 * p + 1, xi[:, 1])):
            row, scale = (p + q) * (p + q + 1) // 2 + p, math.sqrt((2 * p + 1) * (p + q + 1) / 2)
            value[row] = scale * a * b
            d1[row] = scale * a1 * b
            d2[row] = scale * (a2 * b + a * b2)
    return value, d1, d2


def _collapsed_legendre(order, s, h):
    """A_p and its derivatives by xi1, xi2, p = 0 ... order: (p+1) A_(p+1) = (2p+1) s A_p - p h^2 A_(p-1)."""
    zero, one = np.zeros_like(s), np.ones_like(s)
    before, now = (zero, zero, zero), (one, zero, zero)
    for p in range(order + 1):
        yield now
        a, b = (2 * p + 1) / (p + 1), p / (p + 1)
        after = (a * s * now[0] - b * h * h * before[0],
                 a * (now[0] + s * now[1]) - b * h * h * before[1],
                 a * (now[0] / 2 + s * now[2]) - b * (h * h * before[2] - h * before[0]))
        before, now = now, after


def _jacobi(order, alpha, x):
    """P_q^(alpha, 0) and its derivative at x, q = 0 ... order."""
    zero = np.zeros_like(x)
    before, now = (zero, zero), (np.ones_like(x), zero)
    for q in range(order + 1):
        yield now
        if q == 0:
            a, b, c = (alpha + 2) / 2, alpha / 2, 0
        else:
            n = 2 * q + alpha
            scale = 2 * (q + 1) * (q + alpha + 1) * n
            a, b = (n + 1) * n * (n + 2) / scale, (n + 1) * alpha * alpha / scale
            c = 2 * (q + alpha) * q * (n + 2) / scale
        after = ((a * x + b) * now[0] - c * before[0], a * now[0] + (a * x + b) * now[1] - c * before[1])
        before, now = now, after


@functools.lru_cache(maxsize=None)
def gll_points(order):
    """The order + 1 Gauss-Lobatto-Legendre points of [-1, 1], ascending."""
    inner = np.polynomial.legendre.Legendre.basis(order).deriv().roots() if order > 1 else np.empty(0)
    return np.concatenate([[-1.0], np.sort(np.real(inner)), [1.0]])


def lagrange(nodes, x):
    """Values and derivatives at x [n] of the Lagrange polynomials of `nodes`: two arrays [n, nodes]."""
    fit = np.linalg.inv(np.polynomial.legendre.legvander(nodes, len(nodes) - 1))
    slopes = np.polynomial.legendre.legder(fit)
    value = np.polynomial.legendre.legvander(x, len(nodes) - 1) @ fit
    slope = np.polynomial.legendre.legvander(x, max(len(nodes) - 2, 0)) @ slopes
    return value, slope


@functools.lru_cache(maxsize=None)
def tri_nodes(order):
    """Nodes of the triangle [(N + 1)(N + 2) / 2, 2]: vertices, inner nodes of the edges 0 to 2, interior nodes."""
    gll = gll_points(order)[1:-1, None]
    parts = [TRIANGLE]
    for edge in range(3):
        a, b = TRIANGLE[edge], TRIANGLE[(edge + 1) % 3]
        parts.append(a * (1 - gll) / 2 + b * (1 + gll) / 2)
    grid = [((order - j - k) / order, j / order, k / order) for k in range(1, order) for j in range(1, order - k)]
    parts.append(_warped(order, np.array(grid).reshape(-1, 3)))
    return np.concatenate(parts)


def _warped(order, equispaced):
    """Interior nodes: barycentric coordinates moved along the direction of each edge by its blended warp."""
    blend = BLEND[order] if order < len(BLEND) else 5 / 3
    moved = equispaced.copy()
    for k in range(3):
        a, c = (k + 1) % 3, (k + 2) % 3
        la, lc = equispaced[:, a], equispaced[:, c]
        shift = 2 * la * lc * _warp(order, lc - la) * (1 + (blend * equispaced[:, k]) ** 2)
        moved[:, c] += shift
        moved[:, a] -= shift
    return moved @ TRIANGLE


def _warp(order, r):
    """Displacement of a point of an equispaced edge towards the Gauss-Lobatto-Legendre points, over 1 - r^2."""
    if not len(r):
        return r
    equispaced = np.linspace(-1, 1, order + 1)
    return lagrange(equispaced, r)[0] @ (gll_points(order) - equispaced) / (1 - r * r)


@functools.lru_cache(maxsize=None)
def tri_fit(order):
    """The matrix from values at tri_nodes to coefficients of the modes."""
    return np.linalg.inv(tri_modes(order, tri_nodes(order))[0].T)


def sum_modes(coefficients, xi):
    """Sums of modes with coefficients of their own at each point: coefficients [n, modes, k], xi [n, 2].

    Returns values [n, k] and derivatives [n, k, 2] by xi1 and xi2.
    """
    value, d1, d2 = tri_modes(order_of(coefficients.shape[1]), xi)
    derivative = np.stack([np.einsum("nmk,mn->nk", coefficients, d) for d in (d1, d2)], axis=-1)
    return np.einsum("nmk,mn->nk", coefficients, value), derivative
