#!/usr/bin/python3
"""Prints the volume of a hexahedral mesh over what its quads sweep, minus 1.

sweep_volume.py HEX QUADS straight HEIGHT      area times height
sweep_volume.py HEX QUADS revolved DEGREES A   Pappus: the angle times the integral of |x - A|, about the line x = A

An independent reader of both formats: Gauss quadrature that is exact for the polynomials of the elements."""
import sys

import h5py
import numpy as np
from numpy.polynomial import legendre

from element_mesh import gll_points


def basis(order, at):
    """Values and derivatives of the Lagrange polynomials of the Gauss-Lobatto-Legendre points, a row for each point."""
    nodes = np.asarray(gll_points(order))
    to_coefficients = np.linalg.inv(legendre.legvander(nodes, order))
    slopes = np.array([legendre.legval(at, legendre.legder(row)) for row in np.eye(order + 1)]).T
    return legendre.legvander(at, order) @ to_coefficients, slopes @ to_coefficients


def volume(file):
    order = int(file["order"][()])
    points, weights = legendre.leggauss(3 * order // 2 + 1)
    value, slope = basis(order, points)
    nodes = file["nodes"][()][file["elem_nodes"][()]].reshape(-1, *[order + 1] * 3, 3)
    total = 0.0
    for part in np.array_split(nodes, 1 + len(nodes) // 1000):
        part = part - nodes[0, 0, 0, 0]
        along = [np.einsum("ekjid,pi,qj,rk->erqpd", part, *[slope if k == d else value for k in range(3)], optimize=True)
                 for d in range(3)]
        det = np.einsum("...d,...d->...", along[0], np.cross(along[1], along[2]))
        total += np.einsum("erqp,p,q,r->", det, weights, weights, weights)
    return total


def integral(file, function):
    order = int(file["order"][()])
    points, weights = legendre.leggauss(2 * order + 1)
    value, slope = basis(order, points)
    nodes = (file["nodes"][()] + file["face/origin"][()])[file["elem_nodes"][()]].reshape(-1, order + 1, order + 1, 2)
    at, first, second = [np.einsum("ejid,pi,qj->eqpd", nodes, *pair, optimize=True)
                         for pair in ((value, value), (slope, value), (value, slope))]
    det = first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0]
    return np.einsum("eqp,p,q->", det * function(at[..., 0]), weights, weights)


def main(hexes, quads, motion, *numbers):
    amount, *axis = map(float, numbers)
    with h5py.File(hexes) as hex_file, h5py.File(quads) as quad_file:
        if motion == "straight":
            swept = amount * integral(quad_file, np.ones_like)
        else:
            swept = np.radians(amount) * integral(quad_file, lambda x: abs(x - axis[0]))
        print(f"{volume(hex_file) / swept - 1:.3e}")


if __name__ == "__main__":
    main(*sys.argv[1:])
