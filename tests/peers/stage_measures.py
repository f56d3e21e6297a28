"""What other programs must find in x.quad.h5 or x.hex.h5, by numpy alone: det J at points of each element, and the
number of elements and their measure under each name.

The rule of Gauss has POINTS points in each direction: not exact at high orders, but the same number for the same map,
however a program turns an element or a side."""
import re, sys
from dataclasses import dataclass
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).parent.parent / "exports"))
import hex_mesh  # noqa: E402
from quad_file import QuadFile, gll, lagrange  # noqa: E402
from stage_hexes import stage  # noqa: E402

POINTS = 3
AT, WEIGHTS = numpy.polynomial.legendre.leggauss(POINTS)


def rule(dimension):
    """Points [g, dimension], the first coordinate fastest, and weights [g]."""
    grids = numpy.meshgrid(*[AT] * dimension, indexing="ij")
    weights = numpy.ones(1)
    for _ in range(dimension):
        weights = numpy.outer(weights, WEIGHTS).ravel()
    return numpy.stack([g.ravel() for g in reversed(grids)], axis=1), weights


@dataclass
class Measures:
    order: int
    dimension: int         # of the elements
    dets: numpy.ndarray    # det J on [-1, 1]^d: [element, point of rule()], elements in the order of the stage file
    sequence: list         # the elements as writers list them: block by block, of hexahedra region by region
    groups: dict           # (dimension, name) -> (number of elements or sides, measure)
    num_nodes: int
    corners: numpy.ndarray  # [element, corner, axis], of hexahedra the bottom first
    middles: dict          # name -> means of the corners of each side, sorted by rows


def add(groups, key, measure):
    count, before = groups.get(key, (0, 0.0))
    groups[key] = count + 1, before + float(measure)


def plain(name, length=None):
    """A name as formats of plain words have it."""
    return re.sub("[^A-Za-z0-9_.-]", "_", name)[:length]


def sorted_rows(rows):
    """Points [n, axis] in an order that does not depend on rounding."""
    rows = numpy.asarray(rows, dtype=float)
    return rows[numpy.lexsort(numpy.round(rows, 7).T)]


def of_quads(path):
    quads = QuadFile(path)
    dets = quads.jacobian_dets(AT).reshape(len(quads.elems), -1)
    sequence = numpy.argsort(quads.block, kind="stable")
    regions = ["domain" if b in quads.unnamed_blocks else quads.block_names[b] for b in quads.block]
    groups = {}
    for region, measure in zip(regions, dets @ rule(2)[1]):
        add(groups, (2, region), measure)
    _, slope = lagrange(gll(quads.order), AT)
    middles = {}
    for elem, side, curve in quads.sides:
        e = quads.elems[elem]
        nodes = quads.nodes[(e[0, :], e[:, -1], e[-1, :], e[:, 0])[side]]
        add(groups, (1, quads.curve_names[curve]), numpy.linalg.norm(slope @ nodes, axis=1) @ WEIGHTS)
        middles.setdefault(quads.curve_names[curve], []).append((nodes[0] + nodes[-1]) / 2)
    corners = quads.nodes[quads.elems[:, [0, 0, -1, -1], [0, -1, -1, 0]]]
    return Measures(quads.order, 2, dets, sequence, groups, len(quads.nodes), corners,
                    {name: sorted_rows(rows) for name, rows in middles.items()})


def of_hexes(path):
    import h5py
    hexes = stage(path)
    value, slope = lagrange(gll(hexes.order), AT)
    columns = [numpy.einsum("gk,hj,fi,ekjia->eghfa", *three, hexes.nodes, optimize=True)
               for three in ((value, value, slope), (value, slope, value), (slope, value, value))]
    dets = numpy.einsum("...a,...a", columns[0], numpy.cross(columns[1], columns[2])).reshape(len(hexes.nodes), -1)
    groups = {}
    for region, measure in zip(hexes.regions, dets @ rule(3)[1]):
        add(groups, (3, region), measure)
    middles = {}
    for elem, face, name in hexes.faces:
        x = hexes.face_nodes(elem, face)
        middles.setdefault(name, []).append(x[[0, 0, -1, -1], [0, -1, -1, 0]].mean(axis=0))
        u, v = (numpy.einsum("gb,ha,bac->ghc", *two, x) for two in ((value, slope), (slope, value)))
        add(groups, (2, name), WEIGHTS @ numpy.linalg.norm(numpy.cross(u, v), axis=2) @ WEIGHTS)
    with h5py.File(path) as file:
        num_nodes = len(file["nodes"])
    corners = numpy.stack([hexes.nodes[(slice(None), *hexes.corner(c))] for c in range(8)], axis=1)
    names = list(dict.fromkeys(hexes.regions))
    sequence = sorted(range(len(dets)), key=lambda e: names.index(hexes.regions[e]))
    return Measures(hexes.order, 3, dets, sequence, groups, num_nodes, corners,
                    {name: sorted_rows(rows) for name, rows in middles.items()})


def measures(path):
    return of_hexes(path) if path.endswith(".hex.h5") else of_quads(path)


def differences(found, wanted, tolerance=1e-9):
    """Sentences on groups, (dimension, name) -> (number, measure), that differ."""
    said = [f"{key}: found {found.get(key)}, not {wanted.get(key)}" for key in sorted(set(found) ^ set(wanted))]
    for key in sorted(set(found) & set(wanted)):
        (count, size), (right_count, right_size) = found[key], wanted[key]
        if count != right_count or abs(size - right_size) > tolerance * right_size:
            said.append(f"{key}: {count} with measure {size!r}, not {right_count} with {right_size!r}")
    return said
