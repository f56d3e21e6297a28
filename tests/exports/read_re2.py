"""Nek5000's .re2 (version 4) and the geometry field beside it, as Nek5000's reader_re2.f and ic.f read them."""
import json
import struct
from math import dist
from pathlib import Path

from element_mesh import ElementMesh, gll_points, side_indices
from hohqmesh_element import blended, chebyshev_lobatto, lagrange

MARK = struct.pack("<f", 6.54321)


class Bytes:
    def __init__(self, path):
        self.data, self.at = Path(path).read_bytes(), 0

    def text(self, length):
        self.at += length
        return self.data[self.at - length:self.at].decode("ascii")

    def numbers(self, code, count):
        size = struct.calcsize(code) * count
        self.at += size
        return struct.unpack_from(f"<{count}{code}", self.data, self.at - size)

    def mark(self):
        assert self.data[self.at:self.at + 4] == MARK, "not the mark of the byte order"
        self.at += 4

    def records(self):
        """A count, then records: element and side from 1, five numbers, a word."""
        (count,) = self.numbers("d", 1)
        found = []
        for _ in range(int(count)):
            elem, side, *numbers = self.numbers("d", 7)
            found.append((int(elem) - 1, int(side) - 1, numbers, self.text(8)))
        return found


def read(path, order):
    file = Bytes(path)
    header = file.text(80).split()
    num_elements = int(header[1])
    assert header == ["#v004", str(num_elements), "2", str(num_elements), "1", "hdr"], header
    file.mark()
    corners = []
    for _ in range(num_elements):
        group, *x = file.numbers("d", 9)
        assert group == 0
        corners.append([(x[k], x[4 + k], 0.0) for k in range(4)])
    middles = {}
    for elem, side, numbers, word in file.records():
        assert word == "m       " and numbers[2:] == [0, 0, 0]
        middles[elem, side] = (numbers[0], numbers[1], 0.0)
    names = {g["id"]: g["name"] for g in json.loads(Path(f"{path}.names.json").read_text())["boundaries"]}
    boundaries = {}
    for elem, side, numbers, word in file.records():
        assert word == "MSH     " and (elem, side) not in boundaries
        boundaries[elem, side] = names[numbers[4]]
    assert file.at == len(file.data), "something follows"
    quadratic = [quadratic_element(c, {s: middles.get((e, s)) for s in range(4)}, order)
                 for e, c in enumerate(corners)]
    nodes = quadratic if order == 1 else field(str(path)[:-len(".re2")] + "0.f00000", num_elements, order)
    check_against(quadratic, nodes, corners, order)
    return ElementMesh(order, nodes, None, boundaries, len({x for c in corners for x in c}))


def quadratic_element(corners, middles, order):
    """The blend of parabolas that Nek5000 makes, at the GLL points of the given order."""
    ends = ((0, 1), (1, 2), (3, 2), (0, 3))
    curved = [None if middles[s] is None else
              [lagrange((-1, 0, 1), (corners[ends[s][0]], middles[s], corners[ends[s][1]]), t)
               for t in chebyshev_lobatto(max(order, 2))] for s in range(4)]
    return blended(corners, curved, order) if order > 1 else [corners[0], corners[1], corners[3], corners[2]]


def field(path, num_elements, order):
    """Positions of each element's points, x first, then y, by element."""
    file = Bytes(path)
    header = file.text(132).split()
    width = str(order + 1)
    count = str(num_elements)
    assert header[:7] == ["#std", "8", width, width, "1", count, count], header
    assert header[8:12] == ["0", "0", "1", "X"], header
    file.mark()
    assert file.numbers("i", num_elements) == tuple(range(1, num_elements + 1))
    nodes = []
    for _ in range(num_elements):
        x, y = (file.numbers("d", (order + 1) ** 2) for _ in range(2))
        nodes.append([(a, b, 0.0) for a, b in zip(x, y)])
    assert file.at == len(file.data), "something follows"
    return nodes


def check_against(quadratic, nodes, corners, order):
    """Corners are the same bit for bit; sides agree in their middles."""
    gll = gll_points(order)
    for e, points in enumerate(nodes):
        for side in range(4):
            local = side_indices(order, side)
            assert points[local[0]] == corners[e][side], f"a corner of element {e} is not where the field has it"
            ours, theirs = ([p[k] for k in local] for p in (points, quadratic[e]))
            size = dist(ours[0], ours[-1])
            off = dist(lagrange(gll, ours, 0.0), lagrange(gll, theirs, 0.0))
            assert off <= 2e-10 * size + 1e-13, f"the middle of side {side} of element {e} is off by {off:g}"
