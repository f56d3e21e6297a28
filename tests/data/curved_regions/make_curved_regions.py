#!/usr/bin/env python3
"""Writes curved faces with curves inside, and several faces of one curved surface, as STEP files into the folder given,
by default beside itself: python3 make_curved_regions.py [FOLDER]. Plain Python; the same bytes every time. Lengths are
millimetres; cylinders have the radius 1 around the z axis, unless said otherwise."""
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from step_text import Step, real  # noqa: E402

RIGHT, BEGIN = math.pi / 2, .2


def on_cylinder(angle, z, radius=1):
    return radius * math.cos(angle), radius * math.sin(angle), z


class Surfaces(Step):
    """Faces in space. An edge is made by its name once and used in both directions; each face has a surface of its own."""

    def __init__(self):
        super().__init__()
        self.named, self.places, self.faces, self.free = {}, [], [], []

    def xyz(self, p):
        return self.add(f"CARTESIAN_POINT('',({','.join(real(c) for c in p)}))")

    def axis(self, d):
        return self.add(f"DIRECTION('',({','.join(real(c) for c in d)}))")

    def axes(self, centre, z=(0, 0, 1), x=(1, 0, 0)):
        return self.add(f"AXIS2_PLACEMENT_3D('',{self.xyz(centre)},{self.axis(z)},{self.axis(x)})")

    def corner(self, p):
        for known, vertex in self.places:
            if math.dist(known, p) < 1e-9:
                return vertex
        self.places.append((p, self.add(f"VERTEX_POINT('',{self.xyz(p)})")))
        return self.places[-1][1]

    def make(self, key, a, b, curve, name=""):
        self.named[key] = self.add(f"EDGE_CURVE('{name}',{self.corner(a)},{self.corner(b)},{curve},.T.)")

    def line_basis(self, a, b):
        length = math.dist(a, b)
        vector = self.add(f"VECTOR('',{self.axis([(q - p) / length for p, q in zip(a, b)])},1.)")
        return self.add(f"LINE('',{self.xyz(a)},{vector})")

    def line(self, key, a, b, name=""):
        self.make(key, a, b, self.line_basis(a, b), name)

    def arc(self, key, z, begin, end, name="", radius=1):
        circle = self.add(f"CIRCLE('',{self.axes((0, 0, z))},{real(radius)})")
        self.make(key, on_cylinder(begin, z, radius), on_cylinder(end, z, radius), circle, name)

    def tilted_basis(self, c, kx, ky):
        k, angle = math.hypot(kx, ky), math.atan2(ky, kx)
        n = math.hypot(k, 1)
        axes = self.axes((0, 0, c), (-kx / n, -ky / n, 1 / n), (math.cos(angle) / n, math.sin(angle) / n, k / n))
        return self.add(f"ELLIPSE('',{axes},{real(n)},1.)")

    def tilted(self, key, c, kx, ky, begin, end, name=""):
        """The section of the cylinder with the plane z = c + kx x + ky y, counter-clockwise."""
        ends = [on_cylinder(t, c + kx * math.cos(t) + ky * math.sin(t)) for t in (begin, end)]
        self.make(key, *ends, self.tilted_basis(c, kx, ky), name)

    def cylinder(self, reference=0.0, radius=1):
        axes = self.axes((0, 0, 0), (0, 0, 1), (math.cos(reference), math.sin(reference), 0))
        return self.add(f"CYLINDRICAL_SURFACE('',{axes},{real(radius)})")

    def spline_curve(self, poles):
        """Of degree n - 1 with n poles."""
        n = len(poles)
        places = ",".join(self.xyz(p) for p in poles)
        return self.add(f"B_SPLINE_CURVE_WITH_KNOTS('',{n - 1},({places}),.UNSPECIFIED.,.F.,.F.,({n},{n}),(0.,1.),"
                        ".UNSPECIFIED.)")

    def spline_surface(self, rows):
        """Of degree n - 1 in both directions; `rows`: of poles, the second parameter along them."""
        n, m = len(rows), len(rows[0])
        poles = ",".join("(" + ",".join(self.xyz(p) for p in row) + ")" for row in rows)
        return self.add(f"B_SPLINE_SURFACE_WITH_KNOTS('',{n - 1},{m - 1},({poles}),.UNSPECIFIED.,.F.,.F.,.F.,"
                        f"({n},{n}),({m},{m}),(0.,1.),(0.,1.),.UNSPECIFIED.)")

    def face(self, name, surface, loops, sense=True):
        """Loops: keys of edges; "-key" is one in the opposite direction."""
        bounds = []
        for k, loop in enumerate(loops):
            uses = ",".join(self.add(f"ORIENTED_EDGE('',*,*,{self.named[key.lstrip('-')]},"
                                     f"{'.F.' if key.startswith('-') else '.T.'})") for key in loop)
            ring = self.add(f"EDGE_LOOP('',({uses}))")
            bounds.append(self.add(f"{'FACE_OUTER_BOUND' if k == 0 else 'FACE_BOUND'}('',{ring},.T.)"))
        self.faces.append(self.add(f"ADVANCED_FACE('{name}',({','.join(bounds)}),{surface},{'.T.' if sense else '.F.'})"))

    def forget(self):
        """The next faces have edges and vertices of their own."""
        self.named, self.places = {}, []

    def free_arc(self, z, begin, end, name=""):
        circle = self.add(f"CIRCLE('',{self.axes((0, 0, z))},1.)")
        self.trimmed(circle, on_cylinder(begin, z), on_cylinder(end, z), name)

    def free_line(self, a, b, name=""):
        self.trimmed(self.line_basis(a, b), a, b, name)

    def free_tilted(self, c, kx, ky, begin, end, name=""):
        ends = [on_cylinder(t, c + kx * math.cos(t) + ky * math.sin(t)) for t in (begin, end)]
        self.trimmed(self.tilted_basis(c, kx, ky), *ends, name)

    def trimmed(self, basis, a, b, name):
        self.free.append(self.add(f"TRIMMED_CURVE('{name}',{basis},({self.xyz(a)}),({self.xyz(b)}),.T.,.CARTESIAN.)"))

    def text_of(self, name):
        self.product(name, ",".join(self.faces))
        if self.free:
            context = next(f"#{k + 1}" for k, line in enumerate(self.lines) if "REPRESENTATION_CONTEXT('','3D')" in line)
            definition = next(f"#{k + 1}" for k, line in enumerate(self.lines)
                              if line.startswith("PRODUCT_DEFINITION_SHAPE"))
            curves = self.add(f"GEOMETRIC_CURVE_SET('',({','.join(self.free)}))")
            wires = self.add(f"GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION('',({self.origin()},{curves}),{context})")
            self.add(f"SHAPE_DEFINITION_REPRESENTATION({definition},{wires})")
        return self.text(name)


def half(s, z=2, begin=BEGIN, end=2.9):
    """The edges of a part of the cylinder from 0 to z, and its loop."""
    s.arc("bottom", 0, begin, end, "bottom")
    s.arc("top", z, begin, end, "top")
    s.line("right", on_cylinder(begin, 0), on_cylinder(begin, z), "right")
    s.line("left", on_cylinder(end, 0), on_cylinder(end, z), "left")
    return ["bottom", "left", "-top", "-right"]


def tube(s):
    """The edges of the whole cylinder from 0 to 2, and its loop."""
    s.arc("bottom", 0, 0, 0, "bottom")
    s.arc("top", 2, 0, 0, "top")
    s.line("seam", on_cylinder(0, 0), on_cylinder(0, 2))
    return ["bottom", "seam", "-top", "-seam"]


def half_turn():
    """Its arcs have knots where the kernel has vertices, but for rounding."""
    s = Surfaces()
    s.face("sheet", s.cylinder(), [half(s, 2, 0, math.pi)])
    return s


def crack():
    """Along the axis, inside: a wire forth and back."""
    s = Surfaces()
    outline = half(s)
    s.line("crack", on_cylinder(RIGHT, .7), on_cylinder(RIGHT, 1.3), "crack")
    s.face("sheet", s.cylinder(), [outline, ["crack", "-crack"]])
    return s


def crack_on_seam():
    """The same on the line where the parameters of the surface close."""
    s = Surfaces()
    outline = half(s)
    s.line("crack", on_cylinder(RIGHT, .7), on_cylinder(RIGHT, 1.3), "crack")
    s.face("sheet", s.cylinder(RIGHT), [outline, ["crack", "-crack"]])
    return s


def crack_from_rim():
    """Around the axis, from a side: the outline runs along it forth and back."""
    s = Surfaces()
    half(s)
    s.line("below", on_cylinder(BEGIN, 0), on_cylinder(BEGIN, 1), "right")
    s.line("above", on_cylinder(BEGIN, 1), on_cylinder(BEGIN, 2), "right")
    s.arc("crack", 1, BEGIN, RIGHT, "crack")
    s.face("sheet", s.cylinder(), [["bottom", "left", "-top", "-above", "crack", "-crack", "-below"]])
    return s


def tube_crack():
    """A whole tube: its seam is no crack, the other edge that is there twice is one."""
    s = Surfaces()
    outline = tube(s)
    s.line("crack", on_cylinder(math.pi, .6), on_cylinder(math.pi, 1.4), "crack")
    s.face("tube", s.cylinder(), [outline, ["crack", "-crack"]])
    return s


def cracks_free():
    """Curves beside the face: two that cross askew, and one that ends on the first; one is off the face."""
    s = Surfaces()
    s.face("sheet", s.cylinder(), [half(s)])
    s.free_tilted(1, .8, 0, 1.1, 2.1, "falling")
    s.free_line(on_cylinder(1.6, .55), on_cylinder(1.6, 1.45), "upright")
    s.free_line((0, 0, 0), (0, 0, 1))
    return s


def ring_inside():
    """A closed curve beside the face: it divides the tube."""
    s = Surfaces()
    s.face("tube", s.cylinder(), [tube(s)])
    s.free.append(s.tilted_basis(1, .3, .4))
    return s


def halves(own=False, sense=True):
    """A tube of two faces, the cylinder of the second with another reference direction."""
    s = Surfaces()
    for name, begin, end in ("front", BEGIN, 2.9), ("back", 2.9, 2 * math.pi + BEGIN):
        if own:
            s.forget()
        s.arc("bottom" + name, 0, begin, end, "bottom")
        s.arc("top" + name, 2, begin, end, "top")
        for angle in begin, end:
            key = "east" if math.cos(angle) > 0 else "west"
            if key not in s.named:
                s.line(key, on_cylinder(angle, 0), on_cylinder(angle, 2))
        first, second = ("west", "east") if name == "front" else ("east", "west")
        loop = ["bottom" + name, first, "-top" + name, "-" + second]
        if name == "back" and not sense:
            loop = [k[1:] if k[0] == "-" else "-" + k for k in reversed(loop)]
        s.face(name, s.cylinder(begin + .3), [loop], sense or name == "front")
    return s


def stack():
    """Tubes on each other, with a slanted common edge."""
    s = Surfaces()
    s.arc("bottom", 0, 0, 0, "bottom")
    s.arc("top", 3, 0, 0, "top")
    s.tilted("slant", 1.5, .3, .2, 0, 2 * math.pi, "slant")
    s.line("low", on_cylinder(0, 0), on_cylinder(0, 1.8))
    s.line("high", on_cylinder(0, 1.8), on_cylinder(0, 3))
    s.face("lower", s.cylinder(), [["bottom", "low", "-slant", "-low"]])
    s.face("upper", s.cylinder(), [["slant", "high", "-top", "-high"]])
    return s


def window():
    """A face in the hole of another one, with corners, and a third beside both."""
    s = Surfaces()
    half(s)
    for key, z, begin, end in ("sill", .7, 1.1, 1.9), ("lintel", 1.3, 1.1, 1.9):
        s.arc(key, z, begin, end)
    s.line("jamb1", on_cylinder(1.1, .7), on_cylinder(1.1, 1.3))
    s.line("jamb2", on_cylinder(1.9, .7), on_cylinder(1.9, 1.3))
    s.face("wall", s.cylinder(), [["bottom", "left", "-top", "-right"], ["jamb1", "lintel", "-jamb2", "-sill"]])
    s.face("pane", s.cylinder(.2), [["sill", "jamb2", "-lintel", "-jamb1"]])
    return s


def hill(x, y):
    return 2 * x, 2 * y, .6 * (1 - (2 * x - 1) ** 2) * (1 + .3 * y)


def spline():
    """Two faces of a surface of degree 3, each with a copy of it; the common edge is a line of its parameters."""
    rows = [[(i / 3 * 2, j / 3 * 2, .5 * ((i in (1, 2)) * (1 + .4 * j / 3))) for j in range(4)] for i in range(4)]

    def row_at(u):
        weights = [math.comb(3, i) * u ** i * (1 - u) ** (3 - i) for i in range(4)]
        return [tuple(sum(w * rows[i][j][k] for i, w in enumerate(weights)) for k in range(3)) for j in range(4)]

    def column(j, low, high):
        """The part of a column, by de Casteljau."""
        poles = [rows[i][j] for i in range(4)]

        def split(p, t):
            left, right = [p[0]], [p[-1]]
            while len(p) > 1:
                p = [tuple((1 - t) * a + t * b for a, b in zip(q, r)) for q, r in zip(p, p[1:])]
                left.append(p[0])
                right.insert(0, p[-1])
            return left, right

        if high < 1:
            return split(poles, high)[0]
        return split(poles, low)[1] if low > 0 else poles

    s = Surfaces()
    for key, poles, name in (("west", row_at(0), "west"), ("middle", row_at(.45), ""), ("east", row_at(1), "east"),
                             ("south1", column(0, 0, .45), "south"), ("south2", column(0, .45, 1), "south"),
                             ("north1", column(3, 0, .45), "north"), ("north2", column(3, .45, 1), "north")):
        s.make(key, poles[0], poles[-1], s.spline_curve(poles), name)
    s.face("one", s.spline_surface(rows), [["south1", "middle", "-north1", "-west"]])
    s.face("two", s.spline_surface(rows), [["south2", "east", "-north2", "-middle"]])
    return s


def blade():
    """A hole with two sharp ends between two slanted sections."""
    s = Surfaces()
    outline = half(s, 2.4)
    low, high, c = math.pi / 3, 2 * math.pi / 3, math.sin(math.pi / 3)
    s.tilted("upper", 1.2 - 1.6 * c, 0, 1.6, low, high, "blade")
    s.tilted("lower", 1.2 + 1.6 * c, 0, -1.6, low, high, "blade")
    s.face("passage", s.cylinder(), [outline, ["upper", "-lower"]])
    return s


def cap_hole():
    """The unit sphere up to an angle of 1 from its pole, with a round hole whose centre is at 0.35 and radius is 0.2."""
    s = Surfaces()
    for name, tilt, angle in ("rim", 0, 1), ("hole", .35, .2):
        axis, side = (math.sin(tilt), 0, math.cos(tilt)), (math.cos(tilt), 0, -math.sin(tilt))
        centre = [math.cos(angle) * c for c in axis]
        start = [c + math.sin(angle) * d for c, d in zip(centre, side)]
        circle = s.add(f"CIRCLE('',{s.axes(centre, axis, side)},{real(math.sin(angle))})")
        s.make(name, start, start, circle, name)
    s.face("cap", s.add(f"SPHERICAL_SURFACE('',{s.axes((0, 0, 0))},1.)"), [["rim"], ["-hole"]])
    return s


def elbow(begin, num_faces):
    """A quarter of a torus between two circles, of one face or two. Edges along it start at the angle `begin`."""
    s = Surfaces()
    radius, end = .8, math.pi / 4
    seams = [begin + k * math.pi for k in range(num_faces)]

    def place(u, v):
        r = 2 + radius * math.cos(v)
        return r * math.cos(u), r * math.sin(u), radius * math.sin(v)

    def circle(u):
        x = math.cos(u) * math.cos(begin), math.sin(u) * math.cos(begin), math.sin(begin)
        axes = s.axes((2 * math.cos(u), 2 * math.sin(u), 0), (math.sin(u), -math.cos(u), 0), x)
        return s.add(f"CIRCLE('',{axes},{real(radius)})")

    for k, v in enumerate(seams):
        along = s.add(f"CIRCLE('',{s.axes((0, 0, place(0, v)[2]))},{real(2 + radius * math.cos(v))})")
        s.make(f"seam{k}", place(-end, v), place(end, v), along)
        for name, u in ("inlet", -end), ("outlet", end):
            s.make(f"{name}{k}", place(u, v), place(u, seams[(k + 1) % num_faces]), circle(u), name)
    axis = f"AXIS1_PLACEMENT('',{s.xyz((0, 0, 0))},{s.axis((0, 0, 1))})"
    for k in range(num_faces):
        surface = s.add(f"SURFACE_OF_REVOLUTION('',{circle(-end)},{s.add(axis)})")
        s.face(f"part{k}", surface, [[f"seam{k}", f"outlet{k}", f"-seam{(k + 1) % num_faces}", f"-inlet{k}"]])
    return s


def two_surfaces():
    """A cylinder and the plane that continues it."""
    s = Surfaces()
    loop = half(s, 2, 0)
    s.face("round", s.cylinder(), [loop])
    a, b = (1, -1, 0), (1, -1, 2)
    s.line("foot", a, on_cylinder(0, 0))
    s.line("head", b, on_cylinder(0, 2))
    s.line("end", a, b)
    plane = s.add(f"PLANE('',{s.axes((1, 0, 0), (1, 0, 0), (0, 1, 0))})")
    s.face("flat", plane, [["foot", "right", "-head", "-end"]])
    return s


def two_parts(begin, end):
    """Two pieces of one cylinder, the second from `begin` to `end`."""
    s = Surfaces()
    s.face("one", s.cylinder(), [half(s, 2, 0, 1.2)])
    s.forget()
    s.face("two", s.cylinder(), [half(s, 2, begin, end)])
    return s


SHAPES = {"half_turn": half_turn, "crack": crack, "crack_on_seam": crack_on_seam, "crack_from_rim": crack_from_rim,
          "tube_crack": tube_crack, "cracks_free": cracks_free, "ring_inside": ring_inside, "halves": halves,
          "halves_own": lambda: halves(own=True), "halves_turned": lambda: halves(sense=False), "stack": stack,
          "window": window, "spline": spline, "blade": blade, "cap_hole": cap_hole,
          "elbow": lambda: elbow(1.2, 1), "elbow_halves": lambda: elbow(0, 2), "bad_surfaces": two_surfaces,
          "bad_gap": lambda: two_parts(1.4, 2.4), "bad_overlap": lambda: two_parts(.8, 2.0)}

if __name__ == "__main__":
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))
    for shape, made in SHAPES.items():
        with open(os.path.join(folder, shape + ".step"), "w", encoding="ascii") as file:
            file.write(made().text_of(shape))
