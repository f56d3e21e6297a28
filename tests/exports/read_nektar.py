"""Nektar++ XML as the solver reads it: vertices, edges, quads, curves, composites and domain (uncompressed)."""
import re
import xml.etree.ElementTree as ElementTree

from element_mesh import ElementMesh, gll_points, side_indices


def triples(text):
    numbers = [float(word) for word in text.split()]
    assert len(numbers) % 3 == 0, "positions are three numbers each"
    return list(zip(numbers[::3], numbers[1::3], numbers[2::3]))


def unrolled(text, letter):
    """ Q[0-3,7] -> 0 1 2 3 7 """
    inside = re.fullmatch(rf"\s*{letter}\[([-,0-9]+)\]\s*", text)
    assert inside, f"not a list of {letter}: {text}"
    numbers = []
    for part in inside[1].split(","):
        first, _, last = part.partition("-")
        numbers += range(int(first), int(last or first) + 1)
    return numbers


def curves_of(section, letter, key):
    curves = {}
    for curve in section.findall(letter) if section is not None else []:
        assert curve.get("TYPE") == "GaussLobattoLegendre", curve.get("TYPE")
        points = triples(curve.text)
        assert len(points) == int(curve.get("NUMPOINTS")), "NUMPOINTS is not the number of points"
        assert int(curve.get(key)) not in curves, "curved twice"
        curves[int(curve.get(key))] = points
    return curves


def line(a, b, points):
    return [tuple((1 - t) / 2 * p + (1 + t) / 2 * q for p, q in zip(a, b)) for t in points]


class Geometry:
    def __init__(self, root):
        geometry = root.find("GEOMETRY")
        assert (geometry.get("DIM"), geometry.get("SPACE")) in (("2", "2"), ("2", "3"))
        self.vertices = {}
        for v in geometry.find("VERTEX"):
            assert list(v.attrib)[0] == "ID", "the reader takes the first attribute"
            (self.vertices[int(v.get("ID"))],) = triples(v.text)
        assert geometry.get("SPACE") == "3" or all(x[2] == 0 for x in self.vertices.values())
        self.edges = {int(e.get("ID")): tuple(map(int, e.text.split())) for e in geometry.find("EDGE")}
        self.quads = {int(q.get("ID")): tuple(map(int, q.text.split())) for q in geometry.find("ELEMENT").findall("Q")}
        curved = geometry.find("CURVED")
        self.curves, self.faces = curves_of(curved, "E", "EDGEID"), curves_of(curved, "F", "FACEID")
        places = {(frozenset(ends), frozenset(self.curves.get(e, ()))) for e, ends in self.edges.items()}
        assert len(places) == len(self.edges), "an edge is there twice"
        ids = [int(c.get("ID")) for c in curved] if curved is not None else []
        assert len(set(ids)) == len(ids), "curve ids repeat"
        self.composites = {int(c.get("ID")): c for c in geometry.find("COMPOSITE")}
        self.domain = unrolled(geometry.find("DOMAIN").find("D").text, "C")
        self.order = max([len(points) - 1 for points in self.curves.values()], default=None)
        for quad in self.faces:
            for edge in self.quads[quad]:
                assert len(self.curves[edge]) ** 2 == len(self.faces[quad]), "a face and its edges differ in points"

    def corners(self, quad):
        """Vertex j is the end of edge j that edge j + 1 has not."""
        edges = [self.edges[e] for e in self.quads[quad]]
        found = []
        for j in range(4):
            shared = set(edges[j]) & set(edges[(j + 1) % 4])
            assert shared, "consecutive edges share no vertex"
            found.append(next(v for v in edges[j] if v not in shared))
        return found

    def check_directions(self, quad):
        """Opposite edges run the same way, and vertex 0 is where both directions begin: its HDG solver needs it."""
        corners = self.corners(quad)
        along = [self.edges[e][0] == corners[j] for j, e in enumerate(self.quads[quad])]
        assert along[0] != along[2] and along[1] != along[3], "opposite edges are not parallel"
        assert along[0] and not along[3], "the first vertex is not the start of both directions"

    def side(self, quad, j, start, points):
        """Positions along edge j from the vertex `start` on."""
        edge = self.quads[quad][j]
        a, b = self.edges[edge]
        along = self.curves.get(edge) or line(self.vertices[a], self.vertices[b], points)
        assert along[0] == self.vertices[a] and along[-1] == self.vertices[b], "a curve's ends are not its vertices"
        return along if a == start else along[::-1]

    def nodes(self, quad, order):
        """The blend of the sides; a face replaces what is inside."""
        points, corners = gll_points(order), self.corners(quad)
        south, east, north, west = (self.side(quad, j, corners[j], points) for j in range(4))
        north, west = north[::-1], west[::-1]
        found = []
        for j, t in enumerate(points):
            for i, s in enumerate(points):
                a, b, c, d = (1 - s) / 2, (1 + s) / 2, (1 - t) / 2, (1 + t) / 2
                found.append(tuple(
                    c * south[i][k] + d * north[i][k] + a * west[j][k] + b * east[j][k]
                    - a * c * south[0][k] - b * c * south[-1][k] - a * d * north[0][k] - b * d * north[-1][k]
                    for k in range(3)))
        border = [k for j in range(4) for k in side_indices(order, j)]
        for k, x in zip(border, south + east + north[::-1] + west[::-1]):
            found[k] = x
        if quad in self.faces:
            for k in set(range(len(found))) - set(border):
                found[k] = self.faces[quad][k]
        return found


def read(path, order):
    """`order` is that of elements all of whose edges are straight lines: the file need not tell it."""
    root = ElementTree.parse(path).getroot()
    assert root.tag == "NEKTAR"
    geometry = Geometry(root)
    order = geometry.order or order
    edge2side = {}
    for quad, edges in geometry.quads.items():
        for side, edge in enumerate(edges):
            edge2side.setdefault(edge, []).append((quad, side))
    boundaries, regions = {}, {}
    for number, composite in geometry.composites.items():
        if number in geometry.domain:
            for quad in unrolled(composite.text, "Q"):
                assert quad not in regions
                regions[quad] = composite.get("NAME")
        else:
            for edge in unrolled(composite.text, "E"):
                (place,) = edge2side[edge]
                assert place not in boundaries
                boundaries[place] = composite.get("NAME")
    expansion = root.find("EXPANSIONS").find("E")
    assert unrolled(expansion.get("COMPOSITE"), "C") == geometry.domain
    quads = sorted(geometry.quads)
    for quad in quads:
        geometry.check_directions(quad)
    return ElementMesh(order, [geometry.nodes(quad, order) for quad in quads], [regions[quad] for quad in quads],
                       boundaries, len(geometry.vertices),
                       numbers={"faces": len(geometry.faces), "curves": len(geometry.curves)})
