"""Nek5000's .re2 in three dimensions, as reader_re2.f and genxyz.f read it, and the geometry field beside it."""
import json
from pathlib import Path

import numpy

from element_mesh import gll_points
from hex_mesh import FACES, HexElements, lagrange
from read_re2 import Bytes

# genxyz.f, eindx: where the middles of the 12 edges stand in the 3 x 3 x 3 nodes, from 1.
MIDDLES = [2, 6, 8, 4, 20, 24, 26, 22, 10, 12, 18, 16]
CORNERS = [1, 3, 9, 7, 19, 21, 27, 25]
# Faces of the preprocessor: y-, x+, y+, x-, z-, z+.
FACE_OF = [FACES.index(face) for face in ((0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (3, 2, 1, 0),
                                          (4, 5, 6, 7))]


def quadratic(corners, middles):
    """[k, j, i, axis], 3 x 3 x 3: corners, straight edges or their middles, the rest extended from the edges."""
    s = numpy.array([0, 0.5, 1])
    shape = numpy.zeros((3, 3, 3, 3))
    for at, x in zip(CORNERS, corners):
        k, j, i = numpy.unravel_index(at - 1, (3, 3, 3))
        weights = [s if index == 2 else 1 - s for index in (k, j, i)]
        shape += numpy.einsum("a,b,c,x->abcx", *weights, x)
    straight = shape.copy()
    for edge, x in middles.items():
        k, j, i = numpy.unravel_index(MIDDLES[edge] - 1, (3, 3, 3))
        weights = [4 * s * (1 - s) if index == 1 else s if index == 2 else 1 - s for index in (k, j, i)]
        shape += numpy.einsum("a,b,c,x->abcx", *weights, x - straight[k, j, i])
    return shape


def field(path, count, order):
    file = Bytes(path)
    header = file.text(132).split()
    width = str(order + 1)
    assert header[:7] == ["#std", "8", width, width, width, str(count), str(count)], header
    assert header[11] == "X"
    file.mark()
    assert file.numbers("i", count) == tuple(range(1, count + 1))
    values = numpy.array(file.numbers("d", 3 * count * (order + 1) ** 3)).reshape((count, 3) + (order + 1,) * 3)
    assert file.at == len(file.data)
    return numpy.moveaxis(values, 1, -1)


def read(path):
    file = Bytes(path)
    header = file.text(80).split()
    count = int(header[1])
    assert header == ["#v004", str(count), "3", str(count), "1", "hdr"], header
    file.mark()
    groups, corners = [], []
    for _ in range(count):
        group, *x = file.numbers("d", 25)
        groups.append(int(group))
        corners.append(numpy.array(x).reshape(3, 8).T)
    middles = [{} for _ in range(count)]
    for elem, edge, numbers, word in file.records():
        assert word == "m       " and numbers[3:] == [0, 0] and edge not in middles[elem]
        middles[elem][edge] = numpy.array(numbers[:3])
    table = json.loads(Path(f"{path}.names.json").read_text(encoding="utf-8"))
    names = {group["id"]: group["name"] for group in table["boundaries"]}
    regions = {group["id"]: group["name"] for group in table["regions"]}
    faces, partners = [], {}
    for elem, face, numbers, word in file.records():
        assert word in ("MSH     ", "P       ")
        faces.append((elem, FACE_OF[face], names[numbers[4]]))
        if word[0] == "P":
            partners[elem, face] = (int(numbers[0]) - 1, int(numbers[1]) - 1)
    assert file.at == len(file.data), "something follows"
    assert all(partners[other] == at for at, other in partners.items())
    quadratics = numpy.array([quadratic(x, m) for x, m in zip(corners, middles)])
    found = HexElements(2, quadratics, [regions.get(group) for group in groups], faces)
    beside = Path(str(path)[:-len(".re2")] + "0.f00000")
    if beside.exists():
        order = int(beside.read_bytes()[:20].split()[2]) - 1
        full = field(beside, count, order)
        values, _ = lagrange(gll_points(order), [-1, 0, 1])
        at_quadratic = numpy.einsum("ck,bj,ai,ekjix->ecbax", values, values, values, full, optimize=True)
        found.loss["quadratic edges move nodes by"] = float(numpy.abs(at_quadratic - quadratics).max())
        found.order, found.nodes = order, full
    found.loss["periodic faces"] = len(partners)
    return found
