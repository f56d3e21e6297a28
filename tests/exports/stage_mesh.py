"""The quad mesh of x.quad.h5 by another program's eyes: h5dump reads it (formats/quad-mesh.md says what it holds)."""
import re
import subprocess
import tempfile

from element_mesh import ElementMesh

NUMBERS = ["/order", "/face/origin", "/nodes", "/face/plane_origin", "/face/plane_x", "/face/plane_y", "/elem_nodes",
           "/unnamed_blocks", "/boundary_edges/elem", "/boundary_edges/side", "/boundary_edges/curve", "/elem_block",
           "/face/diameter", "/face/metres_per_unit"]


def dump(path, *options):
    return subprocess.run(["h5dump", *options, path], check=True, capture_output=True, text=True).stdout


class Reader:
    def __init__(self, path, folder):
        self.path, self.binary = path, folder + "/data"
        options = [word for name in NUMBERS for word in ("-d", name)]
        text = dump(path, "-A", "0", "-y", "-w", "0", "-m", "%.17g", *options)  # at once: programs take long to start
        parts = re.split(r'^DATASET "(.+)" \{$', text, flags=re.MULTILINE)
        self.texts = dict(zip(parts[1::2], parts[2::2]))

    def numbers(self, name, kind):
        """The values of a dataset of NUMBERS, row by row; kind: int or float."""
        values = re.search(r"DATA \{([^}]*)\}", self.texts[name])[1]
        return [kind(word) for word in values.replace(",", " ").split()]

    def strings(self, name):
        """Fixed length, padded with zeros. The header's first STRSIZE is the data's, what follows are attributes."""
        size = int(re.search(r"STRSIZE (\d+);", dump(self.path, "-d", name, "-H"))[1])
        dump(self.path, "-d", name, "-b", "FILE", "-o", self.binary)
        with open(self.binary, "rb") as file:
            data = file.read()
        return [data[k:k + size].rstrip(b"\0").decode() for k in range(0, len(data), size)]


def read(path, in_space=False):
    """Positions in the face's plane, or in the CAD model's space."""
    with tempfile.TemporaryDirectory() as folder:
        return mesh_of(Reader(path, folder), in_space)


def mesh_of(file, in_space):
    order = file.numbers("/order", int)[0]
    origin = file.numbers("/face/origin", float)
    x = file.numbers("/nodes", float)
    frame = [file.numbers(f"/face/plane_{part}", float) for part in ("origin", "x", "y")]
    frame = frame if in_space else [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
    nodes = []
    for k in range(0, len(x), 2):
        a, b = x[k] + origin[0], x[k + 1] + origin[1]
        nodes.append(tuple(frame[0][c] + a * frame[1][c] + b * frame[2][c] for c in range(3)))
    ids, size = file.numbers("/elem_nodes", int), (order + 1) ** 2
    elements = [[nodes[i] for i in ids[e:e + size]] for e in range(0, len(ids), size)]
    block_names, curve_names = file.strings("/block_names"), file.strings("/face/curve_names")
    for block in file.numbers("/unnamed_blocks", int):
        block_names[block] = "domain"  # all blocks without a name are one region
    edges = zip(*(file.numbers(f"/boundary_edges/{part}", int) for part in ("elem", "side", "curve")))
    return ElementMesh(
        order, elements,
        regions=[block_names[b] for b in file.numbers("/elem_block", int)],
        boundaries={(elem, side): curve_names[curve] or f"curve_{curve}" for elem, side, curve in edges},
        num_vertices=len({e[c] for e in corner_ids(ids, order) for c in range(4)}),
        diameter=file.numbers("/face/diameter", float)[0],
        metres=file.numbers("/face/metres_per_unit", float)[0] or 1)


def corner_ids(ids, order):
    size = (order + 1) ** 2
    for e in range(0, len(ids), size):
        yield [ids[e + k] for k in (0, order, size - 1, size - 1 - order)]
