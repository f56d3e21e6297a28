#!/usr/bin/python3
"""Writes curved faces, each in several parametrisations, as STEP files FACE.NAME.step into a folder.

    parametrised_faces.py FOLDER [FACE]

Surfaces and edges of one face are the same point sets in all of its files. Analytic surfaces have their seam or pole
elsewhere; splines are the exact compositions of rational surfaces with polynomials and Moebius maps, of other degrees
and knots: polynomials are interpolated in spaces of splines that contain them."""
import math
import pathlib
import sys

import numpy

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "data"))
from step_text import Step, real


def basis(degree, knots, t):
    """Values of the B-splines at t."""
    last = len(knots) - degree - 2
    span = min(max(numpy.searchsorted(knots, t, side="right") - 1, degree), last)
    values = numpy.zeros(len(knots) - 1)
    values[span] = 1
    for p in range(1, degree + 1):
        for i in range(len(knots) - p - 1):
            a, b = knots[i + p] - knots[i], knots[i + p + 1] - knots[i + 1]
            left = (t - knots[i]) / a * values[i] if a > 0 else 0
            right = (knots[i + p + 1] - t) / b * values[i + 1] if b > 0 else 0
            values[i] = left + right
    return values[: last + 1]


class Space:
    """Splines of a degree on [0, 1] with these inner knots, each once."""

    def __init__(self, degree, inner=()):
        self.degree = degree
        self.knots = numpy.array([0.0] * (degree + 1) + list(inner) + [1.0] * (degree + 1))
        self.places = [sum(self.knots[i + 1 : i + degree + 1]) / degree for i in range(len(self.knots) - degree - 1)]
        self.from_values = numpy.linalg.inv([basis(degree, self.knots, t) for t in self.places])

    def text(self):
        """Multiplicities and knots."""
        knots = sorted(set(self.knots))
        return (",".join(str(list(self.knots).count(t)) for t in knots), ",".join(map(real, knots)))


def listed(rows):
    return "(" + ",".join(rows) + ")"


class Face(Step):
    """A face as text."""

    def xyz(self, p):
        return self.add(f"CARTESIAN_POINT('',{listed(map(real, p))})")

    def axes(self, centre, z, x):
        directions = [self.add(f"DIRECTION('',{listed(map(real, d))})") for d in (z, x)]
        return self.add(f"AXIS2_PLACEMENT_3D('',{self.xyz(centre)},{','.join(directions)})")

    def spline_curve(self, function, space):
        """function: homogeneous coordinates (w x, w y, w z, w) at t in [0, 1]."""
        poles = space.from_values @ numpy.array([function(t) for t in space.places])
        counts, knots = space.text()
        points = listed(self.xyz(p[:3] / p[3]) for p in poles)
        return self.add(f"( BOUNDED_CURVE() B_SPLINE_CURVE({space.degree},{points},.UNSPECIFIED.,.F.,.F.) "
                        f"B_SPLINE_CURVE_WITH_KNOTS(({counts}),({knots}),.UNSPECIFIED.) CURVE() "
                        "GEOMETRIC_REPRESENTATION_ITEM() "
                        f"RATIONAL_B_SPLINE_CURVE({listed(real(p[3]) for p in poles)}) REPRESENTATION_ITEM('') )")

    def spline_surface(self, function, of_u, of_v):
        """function: homogeneous coordinates at (u, v) in [0, 1]^2."""
        values = numpy.array([[function(u, v) for v in of_v.places] for u in of_u.places])
        poles = numpy.einsum("ai,bj,ijk->abk", of_u.from_values, of_v.from_values, values)
        points = listed(listed(self.xyz(p[:3] / p[3]) for p in row) for row in poles)
        (counts_u, knots_u), (counts_v, knots_v) = of_u.text(), of_v.text()
        return self.add(f"( BOUNDED_SURFACE() B_SPLINE_SURFACE({of_u.degree},{of_v.degree},{points},.UNSPECIFIED.,.F.,"
                        f".F.,.F.) B_SPLINE_SURFACE_WITH_KNOTS(({counts_u}),({counts_v}),({knots_u}),({knots_v}),"
                        ".UNSPECIFIED.) GEOMETRIC_REPRESENTATION_ITEM() RATIONAL_B_SPLINE_SURFACE("
                        f"{listed(listed(real(p[3]) for p in row) for row in poles)}) REPRESENTATION_ITEM('') SURFACE() )")

    def write(self, path, edges, surface, same_sense):
        """edges: of each a function of the step that adds its curve, and its start in homogeneous coordinates; surface: a
        function of the step that adds it."""
        vertices = [self.add(f"VERTEX_POINT('',{self.xyz(p[:3] / p[3])})") for _, p in edges]
        oriented = []
        for k, (curve, _) in enumerate(edges):
            edge = self.add(f"EDGE_CURVE('',{vertices[k]},{vertices[(k + 1) % len(vertices)]},{curve(self)},.T.)")
            oriented.append(self.add(f"ORIENTED_EDGE('',*,*,{edge},.T.)"))
        loop = self.add(f"EDGE_LOOP('',{listed(oriented)})")
        bound = self.add(f"FACE_OUTER_BOUND('',{loop},.T.)")
        face = self.add(f"ADVANCED_FACE('',({bound}),{surface(self)},{'.T.' if same_sense else '.F.'})")
        self.product("face", face)
        path.write_text(self.text("face"), encoding="ascii")


# Maps of [0, 1] onto itself with their degree: (t at s, factor of homogeneous coordinates that makes them polynomials).
IDENTITY = 1, lambda s: (s, 1)
REVERSED = 1, lambda s: (1 - s, 1)


def moebius(rate):
    return 1, lambda s: (rate * s / (1 - s + rate * s), 1 - s + rate * s)


def bent(rate):
    """The speed is from 1 + rate to 1 - rate."""
    return 2, lambda s: (s + rate * s * (1 - s), 1)


class Shape:
    """surface: homogeneous coordinates at (a, b), polynomials of the degrees `degrees`, for the box low..high; outline:
    degree and homogeneous coordinates of edges as functions of t in [0, 1], counter-clockwise in (a, b)."""

    def __init__(self, surface, degrees, low, high, outline):
        self.surface, self.degrees, self.low, self.high, self.outline = surface, degrees, low, high, outline

    def edges(self, change, inner):
        """With the change of parameters and these inner knots."""
        edges = []
        for degree, function in self.outline:
            def at(s, function=function, degree=degree):
                t, factor = change[1](s)
                return factor**degree * numpy.array(function(t), dtype=float)
            space = Space(change[0] * degree, inner)
            edges.append((lambda step, at=at, space=space: step.spline_curve(at, space), at(0.0)))
        return edges

    def spline(self, of_a, of_b, inner_u=(), inner_v=(), exchanged=False):
        """The surface with a and b as these functions of u and v, or of v and u: a function of the step, and whether its
        normal is that of (a, b)."""
        degree_a, degree_b = self.degrees

        def at(u, v):
            (s, of_s), (t, of_t) = of_a[1](v if exchanged else u), of_b[1](u if exchanged else v)
            a, b = (l + x * (h - l) for l, h, x in zip(self.low, self.high, (s, t)))
            return of_s**degree_a * of_t**degree_b * numpy.array(self.surface(a, b), dtype=float)

        degrees = [of_a[0] * degree_a, of_b[0] * degree_b]
        if exchanged:
            degrees.reverse()
        is_same = ((of_a is REVERSED) + (of_b is REVERSED) + exchanged) % 2 == 0
        spaces = Space(degrees[0], inner_u), Space(degrees[1], inner_v)
        return (lambda step: step.spline_surface(at, *spaces)), is_same


def analytic(kind, z, x, *numbers, centre=(0, 0, 0)):
    """A surface of revolution about z through the centre, with its seam on the side of x."""
    return lambda step: step.add(f"{kind}('',{step.axes(centre, z, x)},{','.join(map(real, numbers))})")


def on_surface(surface, degree, way):
    """The edge along way(t) = (a, b)."""
    return degree, lambda t: surface(*way(t))


def splines_of(shape):
    """The same surface: as it is; with other speeds, degrees and knots; with u and v exchanged and one reversed."""
    return {
        "spline": shape.spline(IDENTITY, IDENTITY),
        "bent": shape.spline(moebius(1.7), bent(0.4), inner_v=(0.3, 0.6)),
        "turned": shape.spline(REVERSED, moebius(0.6), inner_u=(0.45,), exchanged=True),
    }


def cylinder():
    """Radius 1, over two edges with two corners: unrolled, half of an uneven disc."""
    k, height = 0.6, 1.2

    def surface(a, b):
        w = 1 + (k * a) ** 2
        return 1 - (k * a) ** 2, 2 * k * a, b * w, w

    outline = [on_surface(surface, 2, lambda t: (2 * t - 1, 0)),
               on_surface(surface, 5, lambda t: (1 - 2 * t, height * (1 - (1 - 2 * t) ** 2) * (1 + 0.3 * (1 - 2 * t))))]
    shape = Shape(surface, (2, 1), (-1.1, -0.1), (1.1, 1.5), outline)
    middle = math.cos(0.3), math.sin(0.3), 0
    return shape, splines_of(shape) | {
        "analytic": (analytic("CYLINDRICAL_SURFACE", (0, 0, 1), (-1, 0, 0), 1), True),
        "seam": (analytic("CYLINDRICAL_SURFACE", (0, 0, -1), middle, 1, centre=(0, 0, 0.5)), True)}


def sphere():
    """Half of the cap with a rim of radius 0.8 of the unit sphere, in stereographic projection half of a disc."""
    def surface(a, b):
        square = a * a + b * b
        return 2 * a, 2 * b, 1 - square, 1 + square

    def rim(t):
        c, s, w = 1 - (2 * t - 1) ** 2, 2 * (2 * t - 1), 1 + (2 * t - 1) ** 2  # from -90 to 90 degrees
        return -0.8 * s, 0.8 * c, 0.6 * w, w

    outline = [on_surface(surface, 2, lambda t: (t - 0.5, 0)), (3, rim)]  # of degree 2 a weight would be 0
    shape = Shape(surface, (2, 2), (-0.55, -0.1), (0.55, 0.55), outline)
    kind = "SPHERICAL_SURFACE"
    return shape, splines_of(shape) | {
        "pole_outside": (analytic(kind, (0, 1, 0), (0, 0, -1), 1), True),
        "pole_inside": (analytic(kind, (0.1, 0.4, 0.9), (1, 0, 0), 1), True),
        "pole_on_edge": (analytic(kind, (0, 0, 1), (1, 0, 0), 1), True),
        "seam": (analytic(kind, (1, 0, 0), (0, 0.3, 0.9), 1), True)}


def cone():
    """A cone of radius 1 - z / 2, beyond the plane x = 0.5, which cuts it in a hyperbola."""
    slope, far = 0.5, 0.5
    end = math.sqrt(1 / 3)

    def surface(a, b):
        radius = 1 - slope * b
        return radius * (1 - a * a), radius * 2 * a, b * (1 + a * a), 1 + a * a

    def hyperbola(t):
        a = end * (1 - 2 * t)
        return far * (1 - a * a), 2 * a * far, ((1 - a * a) - far * (1 + a * a)) / slope, 1 - a * a

    outline = [on_surface(surface, 2, lambda t: (end * (2 * t - 1), 0)), (2, hyperbola)]
    shape = Shape(surface, (2, 1), (-0.7, -0.1), (0.7, 1.1), outline)
    kind, angle = "CONICAL_SURFACE", math.atan(slope)
    return shape, splines_of(shape) | {
        "analytic": (analytic(kind, (0, 0, -1), (-1, 0, 0), 1, angle), True),
        "seam": (analytic(kind, (0, 0, -1), (math.cos(0.3), math.sin(0.3), 0), 0.8, angle, centre=(0, 0, 0.4)), True)}


def torus():
    """Radii 2 and 0.8; an L between circles."""
    def surface(a, b):
        p, q = 1 + a * a, 1 + b * b
        radius = 2 * q + 0.8 * (1 - b * b)
        return radius * (1 - a * a), radius * 2 * a, 0.8 * 2 * b * p, p * q

    corners = [(0, -0.3), (0.5, -0.3), (0.5, 0.05), (0.2, 0.05), (0.2, 0.4), (0, 0.4)]

    def edge(start, stop):
        return on_surface(surface, 2, lambda t: tuple(x + t * (y - x) for x, y in zip(start, stop)))

    shape = Shape(surface, (2, 2), (-0.05, -0.35), (0.6, 0.5),
                  [edge(*ends) for ends in zip(corners, corners[1:] + corners[:1])])
    kind = "TOROIDAL_SURFACE"
    return shape, splines_of(shape) | {
        "analytic": (analytic(kind, (0, 0, 1), (-1, 0, 0), 2, 0.8), True),
        "seam": (analytic(kind, (0, 0, -1), (math.cos(0.2), math.sin(0.2), 0), 2, 0.8), True)}


def hills():
    """Half of a bicubic patch, over a triangle of its parameters."""
    heights = [[0, 0.3, 0.1, -0.1], [0.2, 0.5, -0.2, 0.1], [0.1, -0.3, 0.4, 0.2], [0.0, 0.2, 0.1, 0.3]]
    poles = numpy.array([[(i - 0.5 * j + 0.1 * heights[j][i], 0.85 * j, 1.5 * heights[i][j]) for j in range(4)]
                         for i in range(4)])

    def surface(a, b):
        of_a, of_b = ([math.comb(3, i) * x**i * (1 - x) ** (3 - i) for i in range(4)] for x in (a, b))
        return *numpy.einsum("i,j,ijk->k", of_a, of_b, poles), 1

    corners = [(0, 0), (1, 0), (1, 1)]

    def edge(start, stop):
        is_across = start[0] != stop[0] and start[1] != stop[1]
        return on_surface(surface, 6 if is_across else 3, lambda t: tuple(x + t * (y - x) for x, y in zip(start, stop)))

    shape = Shape(surface, (3, 3), (0, 0), (1, 1), [edge(*ends) for ends in zip(corners, corners[1:] + corners[:1])])
    return shape, splines_of(shape)


FACES = {make.__name__: make for make in (cylinder, sphere, cone, torus, hills)}


def main():
    folder = pathlib.Path(sys.argv[1])
    for name in sys.argv[2:] or FACES:
        shape, surfaces = FACES[name]()
        for number, (kind, (surface, is_same)) in enumerate(surfaces.items()):
            # Curves have other parameters, too, in every other file.
            curve = (moebius(1.4), (0.35, 0.8)) if number % 2 else (IDENTITY, ())
            Face().write(folder / f"{name}.{kind}.step", shape.edges(*curve), surface, is_same)


if __name__ == "__main__":
    main()
