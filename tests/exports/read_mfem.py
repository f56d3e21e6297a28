"""MFEM mesh v1.0 and v1.3 as MFEM reads it: topology, attributes with their names, and the nodes as an H1 grid function
in MFEM's numbering of degrees of freedom, or as an L2 one, element by element, where periodic sides share vertices."""
import json
import re
from pathlib import Path

from element_mesh import ElementMesh, gll_points, side_indices

TOKEN = re.compile(r'"((?:[^"\\]|\\.)*)"|(\S+)')


class Words:
    """The file word by word; a quoted string, as C++'s std::quoted writes it, is one word."""

    def __init__(self, text):
        lines = [line for line in text.split("\n") if not line.startswith("#")]
        self.title, rest = lines[0], "\n".join(lines[1:])
        found = TOKEN.finditer(rest)
        self.words = [re.sub(r'\\(["\\])', r"\1", m[1]) if m[1] is not None else m[2] for m in found]
        self.at = 0

    def next(self):
        self.at += 1
        return self.words[self.at - 1]

    def expect(self, *words):
        for word in words:
            assert self.next() == word, f"no {word} where it belongs"

    def int(self):
        return int(self.next())

    def ints(self, count):
        return [self.int() for _ in range(count)]

    def floats(self, count):
        return [float(self.next()) for _ in range(count)]


def name_sets(words, title):
    """attribute -> name; ours are sets of one attribute each."""
    words.expect(title)
    names = {}
    for _ in range(words.int()):
        name, count = words.next(), words.int()
        for attribute in words.ints(count):
            assert attribute not in names
            names[attribute] = name
    return names


def positions(words, dimension, count):
    return [tuple(words.floats(dimension)) + (0.0,) * (3 - dimension) for _ in range(count)]


def nodes_of(words, elements, num_vertices):
    """Positions of each element's (N+1)^2 nodes: vertices first, then edges in the sequence in which a loop over the
    elements meets them (from the lower vertex to the higher), then the elements' insides."""
    words.expect("FiniteElementSpace", "FiniteElementCollection:")
    space, order = re.fullmatch(r"(H1|L2_T1)_2D_P(\d+)", words.next()).groups()  # T1: Gauss-Lobatto nodes
    order = int(order)
    words.expect("VDim:")
    dimension = words.int()
    words.expect("Ordering:", "1")
    if space != "H1":
        return order, [positions(words, dimension, (order + 1) ** 2) for _ in elements]
    edges = {}
    for corners in elements:
        for side in range(4):
            edges.setdefault(frozenset((corners[side], corners[(side + 1) % 4])), len(edges))
    inner = order - 1
    count = num_vertices + inner * len(edges) + inner ** 2 * len(elements)
    dofs = positions(words, dimension, count)
    all_nodes = []
    for e, corners in enumerate(elements):
        nodes = [None] * (order + 1) ** 2
        for side in range(4):
            local, (a, b) = side_indices(order, side), (corners[side], corners[(side + 1) % 4])
            nodes[local[0]] = dofs[a]
            first = num_vertices + inner * edges[frozenset((a, b))]
            along = dofs[first:first + inner]
            for k, x in zip(local[1:-1], along if a < b else along[::-1]):
                nodes[k] = x
        first = num_vertices + inner * len(edges) + inner ** 2 * e
        for j in range(inner):
            for i in range(inner):
                nodes[(j + 1) * (order + 1) + i + 1] = dofs[first + j * inner + i]
        all_nodes.append(nodes)
    return order, all_nodes


def bilinear(corners, points):
    return [tuple(((1 - s) * (1 - t) * a + (1 + s) * (1 - t) * b + (1 + s) * (1 + t) * c + (1 - s) * (1 + t) * d) / 4
                  for a, b, c, d in zip(*corners)) for t in points for s in points]


def read(path, _order=None):
    words = Words(Path(path).read_text(encoding="utf-8"))
    version = re.fullmatch(r"MFEM mesh v1\.([03])", words.title)[1]
    words.expect("dimension", "2", "elements")
    elements, attributes = [], []
    for _ in range(words.int()):
        attribute, shape, *corners = words.ints(6)
        assert shape == 3 and attribute >= 1
        elements.append(corners)
        attributes.append(attribute)
    region_names = name_sets(words, "attribute_sets") if version == "3" else {}
    words.expect("boundary")
    boundary = []
    for _ in range(words.int()):
        attribute, shape, a, b = words.ints(4)
        assert shape == 1 and attribute >= 1
        boundary.append((attribute, a, b))
    boundary_names = name_sets(words, "bdr_attribute_sets") if version == "3" else {}
    words.expect("vertices")
    num_vertices = words.int()
    assert {v for corners in elements for v in corners} == set(range(num_vertices)), "MFEM drops unused vertices"
    word = words.next()
    if word == "nodes":
        order, nodes = nodes_of(words, elements, num_vertices)
    else:
        order, dimension = 1, int(word)
        x = positions(words, dimension, num_vertices)
        nodes = [bilinear([x[v] for v in corners], gll_points(1)) for corners in elements]
    if version == "3":
        words.expect("mfem_mesh_end")
    assert words.at == len(words.words), "something follows"
    if version == "0":
        region_names, boundary_names = names_beside(path)
    sides = {(e[s], e[(s + 1) % 4]): (k, s) for k, e in enumerate(elements) for s in range(4)}  # as the element runs
    return ElementMesh(order, nodes, [region_names[a] for a in attributes],
                       {sides[a, b]: boundary_names[attribute] for attribute, a, b in boundary}, num_vertices,
                       numbers={"corners": elements})


def names_beside(path):
    """x.mesh.names.json: regions by number, boundaries and interfaces by number."""
    table = json.loads(Path(f"{path}.names.json").read_text(encoding="utf-8"))
    return [{group["id"]: group["name"] for what in kinds for group in table.get(what, [])}
            for kinds in (["regions"], ["boundaries", "interfaces"])]
