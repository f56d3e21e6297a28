#!/usr/bin/python3
"""Judges the mesh of a curved face by the CAD kernel: none of our C++ code is used.

    tests/stress/curved_judge.py [--bin DIR] [--tol DIAMETERS] FILE.step FACE MESH.quad.h5

Prints a line of JSON: the greatest distances, in diameters of the face, of boundary nodes from the edges of the face
(`edges`), of all nodes from its surface (`nodes`) and of points inside elements from it (`inside`); `gap`, the greatest
distance between ends of edges that meet in the file, half of which no mesh can better; `turned`, the least cosine of an
element's normals and that at its centre; `proved`: the projections of all elements along the normal at their centres
have positive Jacobians, by Bernstein coefficients; whether neighbours are oriented alike; the number of quads. Ends
with 1 where `edges` exceeds 1e-12 and half the gap, `inside` exceeds --tol (default: that of quadrefine, by the order,
printed as `tolerance`), an element is not proved, or two neighbours are oriented differently. Needs cad_distances
(ninja curved_faces).
"""
import argparse
import json
import math
import pathlib
import subprocess
import sys

import h5py
import numpy
import scipy.spatial

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOLERANCES = {1: 5e-3, 2: 5e-4, 3: 2e-5}  # quadrefine --help, --geometry-tol
FINEST = 5e-7
ON_EDGE = 1e-12
MOST_POINTS = 4000  # of a group that are measured
SAMPLES = numpy.linspace(-0.9, 0.9, 5)


def gll_points(order):
    """The ends of [-1, 1] and the zeros of the derivative of the Legendre polynomial."""
    inner = numpy.polynomial.legendre.Legendre.basis(order).deriv().roots()
    return numpy.concatenate([[-1.0], numpy.sort(inner.real), [1.0]])


def lagrange(points, samples):
    """Values and derivatives of the Lagrange polynomials of the points at the samples: two arrays [sample, point]."""
    basis = [numpy.polynomial.Polynomial.fromroots(numpy.delete(points, k)) for k in range(len(points))]
    basis = [p / p(points[k]) for k, p in enumerate(basis)]
    return (numpy.array([p(samples) for p in basis]).T, numpy.array([p.deriv()(samples) for p in basis]).T)


def read_mesh(path):
    """Order, nodes in space, node numbers of the elements, and those of boundary edges."""
    with h5py.File(path) as file:
        order = int(file["order"][()])
        nodes = file["space_nodes"][:]
        elems = file["elem_nodes"][:].reshape(-1, (order + 1)**2)
        edges = file["boundary_edges"]
        grid = numpy.arange((order + 1)**2).reshape(order + 1, order + 1)
        sides = [grid[0], grid[:, -1], grid[-1], grid[:, 0]]
        boundary = numpy.unique([elems[e][sides[s]] for e, s in zip(edges["elem"][:], edges["side"][:])])
    return order, nodes, elems, boundary


def inside(order, corners, samples=SAMPLES):
    """Points inside the elements, and normals there: arrays [element, sample, sample, 3]. `corners`: their nodes."""
    values, slopes = lagrange(gll_points(order), samples)
    grids = corners.reshape(-1, order + 1, order + 1, 3)
    tables = (values, values), (slopes, values), (values, slopes)
    along = [numpy.einsum("pj,qi,ejic->epqc", b, a, grids) for a, b in tables]
    return along[0], numpy.cross(along[1], along[2])


def least_cosine(normals):
    unit = normals / numpy.linalg.norm(normals, axis=-1, keepdims=True)
    middle = len(SAMPLES) // 2
    return float(numpy.einsum("epqc,ec->epq", unit, unit[:, middle, middle]).min())


def bernstein(degree, samples):
    """Values of the Bernstein polynomials on [-1, 1]: array [sample, polynomial]."""
    t = (1 + samples) / 2
    return numpy.array([math.comb(degree, k) * t**k * (1 - t)**(degree - k) for k in range(degree + 1)]).T


def all_positive(order, corners, most_halvings=6):
    """Whether det J of each element, projected along its normal at the centre, is positive: its Bernstein coefficients,
    or those of its quarters."""
    degree = 2 * order - 1
    samples = numpy.cos(numpy.pi * (numpy.arange(degree + 1) + 0.5) / (degree + 1))
    to_bernstein = numpy.linalg.inv(bernstein(degree, samples))
    halves = [to_bernstein @ bernstein(degree, (samples + side) / 2) for side in (-1, 1)]
    middle = inside(order, corners, numpy.zeros(1))[1]
    values = numpy.einsum("epqc,ec->epq", inside(order, corners, samples)[1], middle[:, 0, 0])
    rest = numpy.einsum("ip,jq,epq->eij", to_bernstein, to_bernstein, values)
    for _ in range(most_halvings):
        rest = rest[rest.min(axis=(1, 2)) <= 0]
        if not len(rest) or rest[:, [0, 0, -1, -1], [0, -1, 0, -1]].min() <= 0:
            break
        rest = numpy.concatenate([numpy.einsum("ip,jq,epq->eij", a, b, rest) for a in halves for b in halves])
    return not len(rest)


def are_alike(order, elems):
    """Whether no side is run through twice in one direction."""
    corners = elems[:, [0, order, (order + 1)**2 - 1, order * (order + 1)]]
    sides = [(int(a), int(b)) for quad in corners for a, b in zip(quad, numpy.roll(quad, -1))]
    return len(set(sides)) == len(sides)


def thinned(points, most=MOST_POINTS):
    return points[::max(1, -(-len(points) // most))]


def diameter_of(points):
    return float(scipy.spatial.distance.pdist(thinned(points, 1500)).max())


def distances(tool, step, face, groups):
    """The gap of the edges, and the greatest distance of each group ("e" from edges, "f" from the surface; points)."""
    text = "".join(f"{kind} {x:.17g} {y:.17g} {z:.17g}\n" for kind, points in groups for x, y, z in points)
    run = subprocess.run([tool, step, str(face)], input=text, capture_output=True, text=True, check=True)
    _, gap, *values = map(float, run.stdout.split())
    starts = numpy.cumsum([0] + [len(points) for _, points in groups])
    return [gap] + [max(values[a:b]) for a, b in zip(starts, starts[1:])]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "bin")
    parser.add_argument("--tol", type=float)
    parser.add_argument("step")
    parser.add_argument("face", type=int)
    parser.add_argument("mesh")
    args = parser.parse_args()
    order, nodes, elems, boundary = read_mesh(args.mesh)
    points, normals = inside(order, nodes[elems])
    diameter = diameter_of(nodes)
    gap, edges, on, within = (d / diameter for d in distances(args.bin / "cad_distances", args.step, args.face, [
        ("e", thinned(nodes[boundary])), ("f", thinned(nodes)), ("f", thinned(points.reshape(-1, 3)))]))
    turned, proved, alike = least_cosine(normals), all_positive(order, nodes[elems]), are_alike(order, elems)
    tol = args.tol or TOLERANCES.get(order, FINEST)
    print(json.dumps({"quads": len(elems), "order": order, "edges": edges, "gap": gap, "nodes": on, "inside": within,
                      "tolerance": tol, "turned": turned, "proved": proved, "oriented_alike": alike}))
    return 0 if edges <= ON_EDGE + gap / 2 and within <= tol and proved and alike else 1


if __name__ == "__main__":
    sys.exit(main())
