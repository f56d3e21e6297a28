"""Exodus II in NetCDF's classic format, read byte by byte as the specification of NetCDF lists them."""
import struct
from pathlib import Path

from element_mesh import ElementMesh, real_names
from read_abaqus import middle

TYPES = {2: ("c", 1), 4: ("i", 4), 5: ("f", 4), 6: ("d", 8)}
# Nodes in rows, by their place in the file.
ROWS = {4: (0, 1, 3, 2), 8: (0, 4, 1, 7, None, 5, 3, 6, 2), 9: (0, 4, 1, 7, 8, 5, 3, 6, 2)}


class Classic:
    def __init__(self, data):
        assert data[:4] == b"CDF\2"
        self.data, self.at = data, 4
        assert self.int() == 0, "no records"
        self.sizes = [(self.name(), self.int()) for _ in range(self.list(10))]
        self.attributes = self.read_attributes()
        self.variables = dict(self.variable() for _ in range(self.list(11)))

    def int(self, kind="i"):
        (number,) = struct.unpack_from(">" + kind, self.data, self.at)
        self.at += struct.calcsize(kind)
        return number

    def name(self):
        size = self.int()
        text = self.data[self.at:self.at + size].decode()
        self.at += (size + 3) // 4 * 4
        return text

    def list(self, wanted):
        tag, count = self.int(), self.int()
        assert tag == (wanted if count else 0)
        return count

    def values(self, kind, count, at):
        letter, size = TYPES[kind]
        raw = self.data[at:at + size * count]
        assert len(raw) == size * count
        return raw if letter == "c" else list(struct.unpack(f">{count}{letter}", raw))

    def read_attributes(self):
        found = {}
        for _ in range(self.list(12)):
            name, kind, count = self.name(), self.int(), self.int()
            found[name] = self.values(kind, count, self.at)
            self.at += (TYPES[kind][1] * count + 3) // 4 * 4
        return found

    def variable(self):
        name = self.name()
        shape = [self.sizes[self.int()][1] for _ in range(self.int())]
        attributes, kind, size, begin = self.read_attributes(), self.int(), self.int("I"), self.int("q")
        count = 1
        for n in shape:
            count *= n
        assert 0 in shape or size == (count * TYPES[kind][1] + 3) // 4 * 4
        return name, (shape, attributes, self.values(kind, count, begin))


def open_classic(path):
    return Classic(Path(path).read_bytes())


def rows(variable):
    (_, width), _, text = variable
    return [text[k:k + width].rstrip(b"\0").decode() for k in range(0, len(text), width)]


def read(path, _order=None):
    file = open_classic(path)
    x, y = (file.variables[f"coord{c}"][2] for c in "xy")
    sizes = dict(file.sizes)
    assert sizes["num_nodes"] == len(x) == len(y) and sizes["num_dim"] == 2
    names, of_regions = real_names(path), real_names(path, "regions")
    elements, regions, used, corners = [], [], set(), set()
    for block, word in enumerate(rows(file.variables["eb_names"]), 1):
        (_, size), attributes, nodes = file.variables[f"connect{block}"]
        assert attributes["elem_type"] == b"QUAD%d" % size
        for k in range(0, len(nodes), size):
            own = nodes[k:k + size]
            used |= set(own)
            corners |= set(own[:4])
            at = [(x[n - 1], y[n - 1], 0.0) for n in own]
            elements.append([middle(at) if i is None else at[i] for i in ROWS[size]])
            regions.append(of_regions.get(word, word))
    assert used == set(range(1, len(x) + 1)) and sizes["num_elem"] == len(elements)
    boundaries = {}
    for number, word in enumerate(rows(file.variables["ss_names"]), 1):
        for elem, side in zip(*(file.variables[f"{what}_ss{number}"][2] for what in ("elem", "side"))):
            assert (elem - 1, side - 1) not in boundaries
            boundaries[elem - 1, side - 1] = names.get(word, word)
    return ElementMesh(round(len(elements[0]) ** 0.5) - 1, elements, regions, boundaries, len(corners))
