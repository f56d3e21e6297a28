"""What the readers of hexahedra return, with its measures. No code is shared with the writers."""
from dataclasses import dataclass, field
from functools import cache

import numpy

from element_mesh import gll_points

CORNERS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
# The corners of the faces round each, seen from outside.
FACES = [(3, 2, 1, 0), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (4, 5, 6, 7)]
EDGES = [(0, 1), (1, 2), (3, 2), (0, 3), (4, 5), (5, 6), (7, 6), (4, 7), (0, 4), (1, 5), (2, 6), (3, 7)]


@dataclass
class HexElements:
    """Elements as the solver that reads the file would have them: positions [element, k, j, i, axis] at the
    Gauss-Lobatto-Legendre points of the order, faces by the number in FACES."""
    order: int
    nodes: numpy.ndarray
    regions: list                              # a name or number for each element; None: it has none
    faces: list                                # (element, face, name or number) of boundaries and interfaces
    loss: dict = field(default_factory=dict)   # what else a reader found

    def corner(self, c):
        i, j, k = (self.order * index for index in CORNERS[c])
        return k, j, i

    def face_nodes(self, elem, face):
        """[b, a, axis]: a from the first corner to the second, b from the first to the fourth."""
        at = [numpy.array(self.corner(c)) for c in FACES[face]]
        along, across = (at[1] - at[0]) // self.order, (at[3] - at[0]) // self.order
        return numpy.array([[self.nodes[elem][tuple(at[0] + a * along + b * across)] for a in range(self.order + 1)]
                            for b in range(self.order + 1)])


def cut_at_nodes(mesh):
    """The elements of order 1 between the nodes of each element."""
    n, nodes, regions, faces = mesh.order, [], [], []
    cells = [(k, j, i) for k in range(n) for j in range(n) for i in range(n)]
    for elem, x in enumerate(mesh.nodes):
        nodes += [x[k:k + 2, j:j + 2, i:i + 2] for k, j, i in cells]
        regions += [mesh.regions[elem]] * len(cells)
    for elem, face, name in mesh.faces:
        at = [CORNERS[c] for c in FACES[face]]
        axis = [len({index[d] for index in at}) for d in range(3)].index(1)
        wanted = (n - 1) * at[0][axis]
        faces += [(elem * len(cells) + number, face, name) for number, cell in enumerate(cells)
                  if cell[2 - axis] == wanted]
    return HexElements(1, numpy.array(nodes), regions, faces)


def without_inner_nodes(nodes):
    """Nodes [element, 3, 3, 3, axis] with those on faces and inside replaced by what the shape functions of 20 nodes
    make of those on edges: middles of edges less corners, on a face a half and a quarter, inside a quarter and a
    quarter."""
    made, indices = nodes.copy(), range(3)
    for axis in (1, 2, 3):
        for end in (0, 2):
            face = numpy.moveaxis(made, axis, 0)[end]  # a view [element, 3, 3, axis]
            middles = face[:, 0, 1] + face[:, 2, 1] + face[:, 1, 0] + face[:, 1, 2]
            face[:, 1, 1] = middles / 2 - face[:, ::2, ::2].sum(axis=(1, 2)) / 4
    of_edges = sum(nodes[:, k, j, i] for k in indices for j in indices for i in indices if (k, j, i).count(1) == 1)
    made[:, 1, 1, 1] = of_edges / 4 - nodes[:, ::2, ::2, ::2].sum(axis=(1, 2, 3)) / 4
    return made


def sorted_nodes(mesh):
    return sorted(map(tuple, mesh.nodes.reshape(len(mesh.nodes), -1)))


def lagrange(points, at):
    """Values and derivatives [at, point] of the Lagrange polynomials."""
    points = numpy.asarray(points)
    values = numpy.array([[numpy.prod([(x - q) / (p - q) for q in points if q != p]) for p in points] for x in at])
    slopes = numpy.array([[sum(numpy.prod([(x - q) / (p - q) for q in points if q not in (p, r)]) / (p - r)
                               for r in points if r != p) for p in points] for x in at])
    return values, slopes


@cache
def tables(order, count):
    """Values and derivatives at Gauss points, and their weights."""
    at, weights = numpy.polynomial.legendre.leggauss(count)
    return *lagrange(gll_points(order), at), weights


def dets(mesh):
    """det J [element, point] at Gauss points of [-1, 1]^3, and their weights."""
    value, slope, weights = tables(mesh.order, 2 * mesh.order + 1)
    columns = [numpy.einsum("gk,hj,fi,ekjia->eghfa", *three, mesh.nodes, optimize=True)
               for three in ((value, value, slope), (value, slope, value), (slope, value, value))]
    found = numpy.linalg.det(numpy.stack(columns, axis=-1))
    return found.reshape(len(found), -1), numpy.einsum("i,j,k->ijk", weights, weights, weights).ravel()


def area(mesh, elem, face):
    value, slope, weights = tables(mesh.order, 24)
    x = mesh.face_nodes(elem, face)
    u, v = numpy.einsum("gb,ha,bac->ghc", value, slope, x), numpy.einsum("gb,ha,bac->ghc", slope, value, x)
    return float(weights @ numpy.linalg.norm(numpy.cross(u, v), axis=2) @ weights)


def measures(mesh):
    """Volumes by region and areas by name; refuses folded elements."""
    found, weights = dets(mesh)
    assert found.min() > 0, f"det J is {found.min()} in element {found.min(axis=1).argmin()}"
    volumes, areas = {}, {}
    for name, volume in zip(mesh.regions or ["all"] * len(found), found @ weights):
        volumes[name] = volumes.get(name, 0) + float(volume)
    for elem, face, name in mesh.faces:
        areas[name] = areas.get(name, 0) + area(mesh, elem, face)
    return volumes, areas


def equal(found, wanted, tolerance=1e-12):
    """Sentences on measures that differ."""
    said = []
    for what, got, want in zip(("volumes", "areas"), found, wanted):
        if set(got) != set(want):
            said.append(f"{what} of {sorted(map(str, got))} for {sorted(map(str, want))}")
        said += [f"{what}: {name} has {got[name]!r} for {want[name]!r}" for name in want
                 if name in got and abs(got[name] - want[name]) > tolerance * want[name]]
    return said
