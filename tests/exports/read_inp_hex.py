"""Abaqus .inp in HOHQMesh's flavour with hexahedra, as p4est and Trixi.jl (p4est_mesh.jl, transfinite_mappings_3d.jl)
read it: corners of *ELEMENT for the topology, faces and names from the comments."""
from pathlib import Path

import numpy

from element_mesh import gll_points
from hex_mesh import FACES, HexElements, lagrange

# Trixi.jl's faces -y +y -z +x +z -x: corners (first, along p, along q), from 0.
CORNERS = [(0, 1, 4), (3, 2, 7), (0, 1, 3), (1, 2, 5), (4, 5, 7), (0, 3, 4)]
# Names -x +x -y +y -z +z.
NAMES = [(3, 0, 4, 7), (1, 2, 6, 5), (0, 1, 5, 4), (2, 3, 7, 6), (3, 2, 1, 0), (4, 5, 6, 7)]


def chebyshev(order):
    return [-numpy.cos(numpy.pi * k / order) for k in range(order + 1)]


def blended(faces, points):
    """[k, j, i, axis] at points of [-1, 1] from values [q, p] of the six faces there: opposite faces, less edges, plus
    corners."""
    s = (1 + numpy.array(points)) / 2
    low, high = 1 - s, s
    ym, yp, zm, xp, zp, xm = faces  # [zeta, xi], [zeta, xi], [eta, xi], [zeta, eta], [eta, xi], [zeta, eta]
    sigma = (numpy.einsum("i,kjx->kjix", low, xm) + numpy.einsum("i,kjx->kjix", high, xp)
             + numpy.einsum("j,kix->kjix", low, ym) + numpy.einsum("j,kix->kjix", high, yp)
             + numpy.einsum("k,jix->kjix", low, zm) + numpy.einsum("k,jix->kjix", high, zp))
    for face, eta in ((ym, low), (yp, high)):
        for at, zeta in ((0, low), (-1, high)):
            sigma = sigma - numpy.einsum("j,k,ix->kjix", eta, zeta, face[at])
        for at, xi in ((0, low), (-1, high)):
            sigma = sigma - numpy.einsum("j,i,kx->kjix", eta, xi, face[:, at])
    for face, xi in ((xm, low), (xp, high)):
        for at, zeta in ((0, low), (-1, high)):
            sigma = sigma - numpy.einsum("i,k,jx->kjix", xi, zeta, face[at])
    for face, zeta in ((zm, low), (zp, high)):
        for b, eta in ((0, low), (-1, high)):
            for a, xi in ((0, low), (-1, high)):
                sigma = sigma + numpy.einsum("k,j,i,x->kjix", zeta, eta, xi, face[b, a])
    return sigma


def read(path):
    lines = Path(path).read_text(encoding="utf-8").split("\n")
    assert lines[:3] == ["*Heading", " File created by HOHQMesh", "*NODE"]
    start = lines.index("*ELEMENT, type=C3D8, ELSET=Volume1")
    vertices = [numpy.array([float(x) for x in line.split(",")[1:]]) for line in lines[3:start]]
    assert [int(line.split(",")[0]) for line in lines[3:start]] == list(range(1, len(vertices) + 1))
    second = lines.index("** ***** HOHQMesh boundary information ***** **")
    topology = [[int(word) for word in line.split(",")][1:] for line in lines[start + 1:second]]
    degree = lines[second + 1].split()
    order = int(degree[5])
    rest = iter(lines[second + 2:])
    points, wanted = chebyshev(order), gll_points(order)
    values, _ = lagrange(points, wanted)
    s = (1 + numpy.array(points)) / 2
    nodes, num_curved = [], 0
    for _ in topology:
        ids = [int(word) for word in next(rest).split()[1:]]
        flags = [int(word) for word in next(rest).split()[1:]]
        assert len(ids) == 8 and len(flags) == 6 and set(flags) <= {0, 1}
        x = [vertices[k - 1] for k in ids]
        faces = []
        for flag, (origin, along, across) in zip(flags, CORNERS):
            if flag:
                rows = [[float(word) for word in next(rest).split()[1:]] for _ in range((order + 1) ** 2)]
                face = numpy.array(rows).reshape(order + 1, order + 1, 3)
            else:
                opposite = {(0, 1, 4): 5, (3, 2, 7): 6, (0, 1, 3): 2, (1, 2, 5): 6, (4, 5, 7): 6, (0, 3, 4): 7}
                p, q = s[None, :, None], s[:, None, None]
                face = ((1 - p) * (1 - q) * x[origin] + p * (1 - q) * x[along] + (1 - p) * q * x[across]
                        + p * q * x[opposite[origin, along, across]])
            faces.append(numpy.einsum("bq,ap,qpx->bax", values, values, face))
        num_curved += sum(flags)
        nodes.append(blended(faces, wanted))
    named = []
    for elem in range(len(topology)):
        words = next(rest).split()[1:]
        assert len(words) == 6
        named += [(elem, FACES.index(face), word) for face, word in zip(NAMES, words) if word != "---"]
    assert list(rest) == [""], "something follows"
    found = HexElements(order, numpy.array(nodes), None, named)
    found.loss["curved faces"] = num_curved
    found.loss["joined corners"] = len(vertices) - len({v for corners in topology for v in corners})
    return found
