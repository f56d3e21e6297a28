"""The quad mesh of x.quad.h5 by another program's eyes: h5dump reads it (formats/quad-mesh.md says what it holds)."""
import array
import re
import subprocess
import tempfile

from element_mesh import ElementMesh


def dump(path, name, binary=None):
    options = ["-d", name] + (["-b", "FILE", "-o", binary] if binary else ["-H"])
    return subprocess.run(["h5dump", *options, path], check=True, capture_output=True, text=True).stdout


class Reader:
    def __init__(self, path, folder):
        self.path, self.binary = path, folder + "/data"

    def numbers(self, name, code):
        """`code` of Python's array: i for 32-bit integers, d for reals."""
        dump(self.path, name, self.binary)
        with open(self.binary, "rb") as file:
            return array.array(code, file.read())

    def strings(self, name):
        """Fixed length, padded with zeros. The header's first STRSIZE is the data's, what follows are attributes."""
        size = int(re.search(r"STRSIZE (\d+);", dump(self.path, name))[1])
        dump(self.path, name, self.binary)
        with open(self.binary, "rb") as file:
            data = file.read()
        return [data[k:k + size].rstrip(b"\0").decode() for k in range(0, len(data), size)]


def read(path, in_space=False):
    """Positions in the face's plane, or in the CAD model's space."""
    with tempfile.TemporaryDirectory() as folder:
        return mesh_of(Reader(path, folder), in_space)


def mesh_of(file, in_space):
    order = file.numbers("/order", "i")[0]
    origin = file.numbers("/face/origin", "d")
    x = file.numbers("/nodes", "d")
    frame = [file.numbers(f"/face/plane_{part}", "d") for part in ("origin", "x", "y")]
    frame = frame if in_space else [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
    nodes = []
    for k in range(0, len(x), 2):
        a, b = x[k] + origin[0], x[k + 1] + origin[1]
        nodes.append(tuple(frame[0][c] + a * frame[1][c] + b * frame[2][c] for c in range(3)))
    ids, size = file.numbers("/elem_nodes", "i"), (order + 1) ** 2
    elements = [[nodes[i] for i in ids[e:e + size]] for e in range(0, len(ids), size)]
    block_names, curve_names = file.strings("/block_names"), file.strings("/face/curve_names")
    for block in file.numbers("/unnamed_blocks", "i"):
        block_names[block] = "domain"  # all blocks without a name are one region
    edges = zip(*(file.numbers(f"/boundary_edges/{part}", "i") for part in ("elem", "side", "curve")))
    return ElementMesh(
        order, elements,
        regions=[block_names[b] for b in file.numbers("/elem_block", "i")],
        boundaries={(elem, side): curve_names[curve] or f"curve_{curve}" for elem, side, curve in edges},
        num_vertices=len({e[c] for e in corner_ids(ids, order) for c in range(4)}),
        diameter=file.numbers("/face/diameter", "d")[0],
        metres=file.numbers("/face/metres_per_unit", "d")[0] or 1)


def corner_ids(ids, order):
    size = (order + 1) ** 2
    for e in range(0, len(ids), size):
        yield [ids[e + k] for k in (0, order, size - 1, size - 1 - order)]
