"""Nektar++ XML of hexahedra as HexGeom and QuadGeom read it: local edges and vertices follow from the faces, points of
faces from those of their edges, points inside from the faces by blending. Source: Nektar++, SpatialDomains."""
import re
import xml.etree.ElementTree as ET

import numpy

from element_mesh import gll_points
from hex_mesh import EDGES, HexElements

# Nektar++'s local faces by corners (bottom, y-, x+, y+, x-, top) are those of FACES.
NEIGHBOURS = [(0, 1), (0, 2), (0, 3), (0, 4), (5, 1), (5, 2), (5, 3), (5, 4), (1, 4), (1, 2), (2, 3), (3, 4)]


def numbers(text):
    return [int(word) for word in text.split()]


def members(text):
    """{letter, entity numbers} of "F[0-3,7]"."""
    letter, listed = re.fullmatch(r"\s*([A-Z])\[([^\]]*)\]\s*", text).groups()
    found = []
    for part in listed.split(","):
        first, _, last = part.partition("-")
        found += range(int(first), int(last or first) + 1)
    return letter, found


def common(a, b):
    shared = set(a) & set(b)
    assert len(shared) == 1, (a, b)
    return shared.pop()


class Mesh:
    def __init__(self, root):
        geometry = root.find("GEOMETRY")
        assert geometry.attrib == {"DIM": "3", "SPACE": "3"}
        self.vertices = [numpy.array([float(x) for x in v.text.split()]) for v in geometry.find("VERTEX")]
        self.edges = [numbers(e.text) for e in geometry.find("EDGE")]
        self.faces = [numbers(q.text) for q in geometry.find("FACE")]
        self.elements = [numbers(h.text) for h in geometry.find("ELEMENT")]
        self.edge_curves, self.face_curves = {}, {}
        for curve in geometry.findall("CURVED/*"):
            assert curve.get("TYPE") == "GaussLobattoLegendre"
            points = numpy.array([float(x) for x in curve.text.split()]).reshape(-1, 3)
            assert len(points) == int(curve.get("NUMPOINTS"))
            if curve.tag == "E":
                self.edge_curves[int(curve.get("EDGEID"))] = points
            else:
                side = round(len(points) ** 0.5)
                self.face_curves[int(curve.get("FACEID"))] = points.reshape(side, side, 3)
        counts = {len(points) for points in self.edge_curves.values()}
        assert len(counts) <= 1 and all(len(points) in counts for points in self.face_curves.values())
        self.count = counts.pop() if counts else 2
        self.points = (1 + numpy.array(gll_points(self.count - 1))) / 2
        for face in self.face_curves:
            assert all(edge in self.edge_curves for edge in self.faces[face]), "a curved face has curved edges"

    def edge(self, number, start):
        """The points of an edge from one of its vertices on."""
        a, b = self.edges[number]
        s = self.points[:, None]
        x = self.edge_curves.get(number)
        if x is None:
            x = (1 - s) * self.vertices[a] + s * self.vertices[b]
        assert numpy.array_equal(x[0], self.vertices[a]) and numpy.array_equal(x[-1], self.vertices[b])
        return x if a == start else x[::-1]

    def face_corners(self, number):
        e = self.faces[number]
        return [common(self.edges[e[k - 1]], self.edges[e[k]]) for k in range(4)]

    def face(self, number, start, second):
        """The points [b, a] of a face: a from vertex `start` to vertex `second`."""
        v, e = self.face_corners(number), self.faces[number]
        sides = [self.edge(e[0], v[0]), self.edge(e[1], v[1]), self.edge(e[2], v[3]), self.edge(e[3], v[0])]
        x = self.face_curves.get(number)
        if x is None:
            a, b = self.points[None, :, None], self.points[:, None, None]
            x = ((1 - b) * sides[0] + b * sides[2] + (1 - a) * sides[3][:, None] + a * sides[1][:, None]
                 - (1 - a) * (1 - b) * sides[0][0] - a * (1 - b) * sides[0][-1]
                 - (1 - a) * b * sides[2][0] - a * b * sides[2][-1])
        for along, side in zip((x[0], x[:, -1], x[-1], x[:, 0]), sides):
            assert numpy.abs(along - side).max() < 1e-13 * (1 + numpy.abs(x).max()), f"face {number} leaves its edges"
        grid = {v[0]: (0, 0), v[1]: (0, -1), v[2]: (-1, -1), v[3]: (-1, 0)}
        if grid[start][0] != 0:
            x = x[::-1]
        if grid[start][1] != 0:
            x = x[:, ::-1]
        runs_along_first = grid[start][0] == grid[second][0]
        return x if runs_along_first else x.transpose(1, 0, 2)

    def element(self, number):
        """[k, j, i, axis], the local edges, and the local corners."""
        f = self.elements[number]
        edges = [common(self.faces[f[a]], self.faces[f[b]]) for a, b in NEIGHBOURS]
        at = [self.edges[e] for e in edges]
        corners = [common(at[3], at[0]), common(at[0], at[1]), common(at[1], at[2]), common(at[2], at[3]),
                   common(at[7], at[4]), common(at[4], at[5]), common(at[5], at[6]), common(at[6], at[7])]
        s, n = self.points, self.count - 1
        rest = numpy.zeros((n + 1,) * 3 + (3,))
        faces = [self.face(f[0], corners[0], corners[1]), self.face(f[5], corners[4], corners[5]),  # z
                 self.face(f[1], corners[0], corners[1]), self.face(f[3], corners[3], corners[2]),  # y
                 self.face(f[4], corners[0], corners[3]), self.face(f[2], corners[1], corners[2])]  # x
        # Boolean sum of the linear interpolations between opposite faces.
        for axis, pair in ((0, faces[0:2]), (1, faces[2:4]), (2, faces[4:6])):
            low, high = (x - numpy.take(rest, at, axis=axis) for at, x in zip((0, n), pair))
            t = s.reshape([-1 if k == axis else 1 for k in range(4)])
            rest = rest + (1 - t) * numpy.expand_dims(low, axis) + t * numpy.expand_dims(high, axis)
        return rest, edges, corners


def read(path):
    root = ET.parse(path).getroot()
    mesh = Mesh(root)
    nodes = []
    directed = 0
    for number in range(len(mesh.elements)):
        x, edges, corners = mesh.element(number)
        nodes.append(x)
        along = [mesh.edges[e][0] == corners[a] for e, (a, _) in zip(edges, EDGES)]
        directed += all(len(set(along[k] for k in group)) == 1 for group in ((0, 2, 4, 6), (1, 3, 5, 7), range(8, 12)))
    regions, faces = [None] * len(nodes), []
    owners = {}
    for e, local in enumerate(mesh.elements):
        for k, face in enumerate(local):
            owners.setdefault(face, (e, k))
    for composite in root.find("GEOMETRY/COMPOSITE"):
        letter, listed = members(composite.text)
        for number in listed:
            if letter == "H":
                regions[number] = composite.get("NAME")
            else:
                assert letter == "F"
                faces.append((*owners[number], composite.get("NAME")))
    assert root.find("EXPANSIONS/E").get("NUMMODES") == str(mesh.count) or mesh.count == 2
    found = HexElements(mesh.count - 1, numpy.array(nodes), regions, faces)
    found.loss["elements with directed edges"] = directed
    return found
