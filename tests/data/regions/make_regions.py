#!/usr/bin/env python3
"""Writes faces of several regions, and faces with curves inside, as STEP files into the folder given, by default beside
itself: python3 make_regions.py [FOLDER]. Plain Python; the same bytes every time. Lengths are millimetres."""
import cmath
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from iges_text import Iges  # noqa: E402
from make_shapes import naca0012  # noqa: E402
from step_text import Step, polygon, real, rectangle  # noqa: E402


class Sheet(Step):
    """Several faces in one file. Faces share the edges that are the same curve, unless `own` is given: then a face has
    edges and vertices of its own, as if it had been drawn alone."""

    def __init__(self, frame=None):
        super().__init__(frame)
        self.shared = {}
        self.faces, self.free = [], []

    def edge(self, a, b, curve, same, name=""):
        edge = self.add(f"EDGE_CURVE('{name}',{self.vertex(a)},{self.vertex(b)},{curve},.T.)")
        self.edges.append(edge)
        self.last = edge, a
        return self.add(f"ORIENTED_EDGE('',*,*,{edge},{'.T.' if same else '.F.'})")

    @staticmethod
    def key(kind, *args):
        """Of the curve, whatever its direction."""
        def near(z):
            return round(z.real, 9) + 0.0, round(z.imag, 9) + 0.0
        if kind == "circle":
            return kind, near(args[0]), round(args[1], 9), *(near(z) for z in args[3:] if not isinstance(z, str))
        if kind == "spline":
            return kind, *sorted([near(args[0][0]), near(args[0][-1])]), near(args[0][len(args[0]) // 2])
        if kind == "arc":
            ends = (args[2], args[3]) if args[4] > 0 else (args[3], args[2])
            return kind, near(args[0]), *map(near, ends)
        return kind, *sorted([near(args[0]), near(args[1])])

    def use(self, kind, *args):
        key = self.key(kind, *args)
        if key in self.shared:
            edge, start = self.shared[key]
            same = {"circle": lambda: args[2] > 0, "arc": lambda: args[4] > 0,
                    "line": lambda: abs(args[0] - start) < 1e-9,
                    "spline": lambda: abs(args[0][0] - start) < 1e-9}[kind]()
            return self.add(f"ORIENTED_EDGE('',*,*,{edge},{'.T.' if same else '.F.'})")
        use = getattr(self, kind + "_edge")(*args)
        self.shared[key] = self.last
        return use

    def circle_edge(self, centre, radius, side, *rest):
        """`rest`: the name, or the seam's place and the name; the seam is at centre + radius else."""
        seam = next((z for z in rest if not isinstance(z, str)), centre + radius)
        name = next((z for z in rest if isinstance(z, str)), "")
        return self.edge(seam, seam, self.circle(centre, radius), side > 0, name)

    def region(self, name, loops, own=False):
        if own:
            kept, self.shared, self.vertices = (self.shared, self.vertices), {}, {}
        bounds = []
        for k, loop in enumerate(loops):
            ring = self.add(f"EDGE_LOOP('',({','.join(self.use(*edge) for edge in loop)}))")
            bounds.append(self.add(f"{'FACE_OUTER_BOUND' if k == 0 else 'FACE_BOUND'}('',{ring},.T.)"))
        plane = self.add(f"PLANE('',{self.placement(0j)})")
        self.faces.append(self.add(f"ADVANCED_FACE('{name}',({','.join(bounds)}),{plane},.T.)"))
        if own:
            self.shared, self.vertices = kept

    def curve(self, kind, *args):
        """A curve beside the faces, in a set of curves: ("line", a, b), ("arc", centre, radius, a, b, 1) or a circle."""
        name = next((z for z in args if isinstance(z, str)), "")
        if kind == "line":
            a, b = args[:2]
            d = (b - a) / abs(b - a)
            vector = self.add(f"VECTOR('',{self.direction(d.real, d.imag, 0)},1.)")
            basis = self.add(f"LINE('',{self.point(a)},{vector})")
        else:
            basis = self.circle(args[0], args[1])
            if kind == "circle":
                return self.free.append(basis)
            a, b = args[2:4]
        self.free.append(self.add(f"TRIMMED_CURVE('{name}',{basis},({self.point(a)}),({self.point(b)}),.T.,.CARTESIAN.)"))

    def wireframe(self, name):
        """The curves alone, without a face."""
        self.representation(name, "GEOMETRICALLY_BOUNDED_WIREFRAME",
                            self.add(f"GEOMETRIC_CURVE_SET('',({','.join(self.free)}))"))

    def product(self, name, _=None):
        super().product(name, ",".join(self.faces))
        if not self.free:
            return
        context = next(f"#{k + 1}" for k, line in enumerate(self.lines) if "REPRESENTATION_CONTEXT('','3D')" in line)
        definition = next(f"#{k + 1}" for k, line in enumerate(self.lines) if line.startswith("PRODUCT_DEFINITION_SHAPE"))
        curves = self.add(f"GEOMETRIC_CURVE_SET('',({','.join(self.free)}))")
        wires = self.add(f"GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION('',({self.origin()},{curves}),{context})")
        self.add(f"SHAPE_DEFINITION_REPRESENTATION({definition},{wires})")


def sheet(name, regions, curves=(), own=False, frame=None):
    step = Sheet(frame)
    for region, loops in regions:
        step.region(region, loops, own)
    for curve in curves:
        step.curve(*curve)
    step.product(name)
    return step.text(name)


def circle(centre, radius, *rest):
    return [("circle", complex(centre), radius, 1, *rest)]


def hole(loop):
    """The loop the other way round."""
    back = []
    for edge in reversed(loop):
        kind, *args = edge
        if kind == "line":
            args[:2] = args[1], args[0]
        elif kind == "arc":
            args[2:5] = args[3], args[2], -args[4]
        elif kind == "circle":
            args[2] = -args[2]
        elif kind == "spline":
            args[0], args[1] = args[0][::-1], [args[1][0] + args[1][-1] - t for t in reversed(args[1])]
        back.append((kind, *args))
    return back


def offset(loop, thickness):
    """Outwards, of a loop of lines and arcs without corners, counter-clockwise."""
    result = []
    for kind, *args in loop:
        if kind == "line":
            a, b = args[:2]
            out = -1j * (b - a) / abs(b - a) * thickness
            result.append(("line", a + out, b + out))
        elif kind == "circle":
            result.append(("circle", args[0], args[1] + thickness, *args[2:]))
        else:
            centre, radius, a, b, side = args[:5]
            grown = radius + side * thickness
            result.append(("arc", centre, grown, *(centre + (z - centre) * grown / radius for z in (a, b)), side))
    return result


def gear(teeth=6):
    corners, radii = [], []
    for k in range(teeth):
        for radius, fraction, fillet in ((8, -0.32, 0.5), (8, 0.32, 0.5), (10, 0.40, 0.4), (10, 0.60, 0.4)):
            corners.append(radius * cmath.exp(2j * math.pi * (k + fraction - 0.18 * (radius == 8) * (fraction > 0)
                                                              + 0.18 * (radius == 8) * (fraction < 0)) / teeth))
            radii.append(fillet)
    return polygon(corners, radii)


def cam():
    """Base circle, nose and the two tangents between them."""
    base, nose, lift = 10, 4, 12
    angle = math.acos((base - nose) / lift)
    tips = [cmath.exp(-1j * angle), cmath.exp(1j * angle)]
    return [("arc", complex(lift), nose, lift + nose * tips[0], lift + nose * tips[1], 1),
            ("line", lift + nose * tips[1], base * tips[1]), ("arc", 0j, base, base * tips[1], base * tips[0], 1),
            ("line", base * tips[0], lift + nose * tips[0])]


def clipped(cell, point, normal):
    """The part of a convex polygon with (z - point) . normal <= 0."""
    side = [((z - point) * normal.conjugate()).real for z in cell]
    result = []
    for k, z in enumerate(cell):
        if side[k - 1] * side[k] < 0:
            result.append(cell[k - 1] + (z - cell[k - 1]) * side[k - 1] / (side[k - 1] - side[k]))
        if side[k] <= 0:
            result.append(z)
    return result


def cells_of(sites):
    square = [0j, 1 + 0j, 1 + 1j, 1j]
    cells = []
    for a in sites:
        cell = square
        for b in sites:
            if a != b:
                cell = clipped(cell, (a + b) / 2, b - a)
        cells.append(cell)
    return cells


def centroid(cell):
    areas = [(a.conjugate() * b).imag / 2 for a, b in zip(cell, cell[1:] + cell[:1])]
    return sum(s * (a + b) / 3 for s, a, b in zip(areas, cell, cell[1:] + cell[:1])) / sum(areas)


def voronoi(count=20):
    """Cells in the unit square, relaxed so that no edge is tiny; the corners of neighbours are the same numbers."""
    state, sites = 12345, []
    for _ in range(count):
        numbers = []
        for _ in range(2):
            state = (1103515245 * state + 12345) % 2**31
            numbers.append(state / 2**31)
        sites.append(complex(*numbers))
    for _ in range(12):
        sites = [centroid(cell) for cell in cells_of(sites)]
    return [[10 * complex(round(z.real, 12), round(z.imag, 12)) for z in cell] for cell in cells_of(sites)]


def with_corners(cells):
    """Each cell with the corners of its neighbours that lie on its edges."""
    corners = [z for cell in cells for z in cell]
    result = []
    for cell in cells:
        points = []
        for a, b in zip(cell, cell[1:] + cell[:1]):
            on = [z for z in corners if abs(z - a) > 1e-7 and abs(z - b) > 1e-7
                  and abs(abs(z - a) + abs(z - b) - abs(b - a)) < 1e-9]
            points.append(a)
            for z in sorted(on, key=lambda z: abs(z - a)):
                if abs(z - points[-1]) > 1e-7:
                    points.append(z)
        result.append(points)
    return result


def board(n, radius):
    """n x n unit squares around the origin; a disc around the origin is left out."""
    cells = []
    for j in range(n):
        for i in range(n):
            low = complex(i - n / 2, j - n / 2)
            corners = [low, low + 1, low + 1 + 1j, low + 1j]
            if 0j in corners:
                k = corners.index(0j)
                before, after = corners[k - 1], corners[(k + 1) % 4]
                loop = polygon(corners[k + 1:] + corners[:k])[:-1] if k else polygon(corners[1:])[:-1]
                a, b = radius * before / abs(before), radius * after / abs(after)
                loop += [("line", before, a), ("arc", 0j, radius, a, b, -1), ("line", b, after)]
            else:
                loop = polygon(corners)
            cells.append(("black" if (i + j) % 2 == 0 else "white", [loop]))
    return cells


def cable():
    """Three conductors with insulation in a filler, inside a sheath."""
    centres = [5 * cmath.exp(2j * math.pi * k / 3 + 0.5j * math.pi) for k in range(3)]
    regions = [("sheath", [circle(0, 12), hole(circle(0, 10.5))]),
               ("filler", [circle(0, 10.5)] + [hole(circle(z, 3.6)) for z in centres])]
    for z in centres:
        regions.append(("insulation", [circle(z, 3.6), hole(circle(z, 2.8))]))
        regions.append(("conductor", [circle(z, 2.8)]))
    return regions


def seal():
    """A lip seal: a body of rubber around a metal ring of L-shaped section, with a thin layer of bond between."""
    metal = polygon([2 + 2j, 10 + 2j, 10 + 4j, 4 + 4j, 4 + 9j, 2 + 9j], [0.6, 0.6, 0.6, 0.8, 0.6, 0.6])
    bond = offset(metal, 0.25)
    rubber = polygon([0, 13, 12 + 6j, 7 + 6j, 6 + 11j, 11j])
    return [("rubber", [rubber, hole(bond)]), ("bond", [bond, hole(metal)]), ("metal", [metal])]


def beam():
    """A sandwich: a core between skins, and a patch that ends on the upper skin."""
    return [("core", [rectangle(0j, 60 + 10j)]), ("skin", [rectangle(-1j, 60 + 0j)]), ("skin", [rectangle(10j, 60 + 11j)]),
            ("patch", [polygon([20 + 11j, 45 + 11j, 42 + 12.5j, 23 + 12.5j])])]


def pins():
    centres = [8 + 5j, 8 + 15j, 20 + 10j, 32 + 5j, 32 + 15j]
    return [("fluid", [rectangle(0j, 40 + 20j)] + [hole(circle(z, 2.5)) for z in centres])] + [
        (f"pin{k}", [circle(z, 2.5, z + 2.5j)]) for k, z in enumerate(centres)]


def t_joint(shift):
    return [("base", [rectangle(0j, 2 + 1j)]), ("left", [rectangle(complex(0, 1 + shift), complex(0.8 - shift, 2))]),
            ("right", [rectangle(0.8 + 1j, 2 + 2j)])]


def upper_half(z, radius):
    return [("line", z - radius, z + radius), ("arc", z, radius, z + radius, z - radius, 1)]


def moved(loop, turn, shift):
    """A chain of edges under z -> turn z + shift."""
    def image(arg):
        if isinstance(arg, complex):
            return turn * arg + shift
        return [turn * z + shift for z in arg] if isinstance(arg, list) and isinstance(arg[0], complex) else arg
    return [(kind, *map(image, args)) for kind, *args in loop]


def named(chain, name):
    return [(*edge, name) for edge in chain]


def spline(points):
    """A cubic with these poles."""
    count = len(points) - 3
    return "spline", points, [0.0] * 4 + [float(k) for k in range(1, count)] + [float(count)] * 4


def periodic_box():
    """A box with a hole off its centre, which repeats in both directions."""
    return [("line", 0j, 4 + 0j, "bottom"), ("line", 4 + 0j, 4 + 3j, "right"), ("line", 4 + 3j, 3j, "top"),
            ("line", 3j, 0j, "left")], circle(1.7 + 1.4j, 0.6)


def blade_passage(pitch=1.1):
    """Around one blade: an inlet, an outlet at right angles, and a curved cut of three edges that repeats above."""
    cut = [("line", -1 - 0.55j, -0.4 - 0.55j),
           spline([-0.4 - 0.55j, -0.1 - 0.55j, 0.3 - 0.5j, 0.7 - 0.65j, 1.1 - 0.8j, 1.4 - 0.8j]),
           ("line", 1.4 - 0.8j, 2 - 0.8j)]
    _, poles, knots = naca0012()[0]
    cambered = [complex(z.real, z.imag + 0.3 * z.real * (1 - z.real)) * cmath.exp(-0.25j) - 0.02j for z in poles]
    above = hole(moved(cut, 1, 1j * pitch))
    outline = named(cut, "below") + [("line", cut[-1][2], cut[-1][2] + 1j * pitch, "outlet")] + named(above, "above")
    return outline + [("line", above[-1][2], cut[0][1], "inlet")], [("spline", cambered, knots, "blade")]


def wavy_channel():
    """One wave of a channel whose walls are waves of different height."""
    def wave(height, low):
        return spline([low + 0j, 0.5 + low, 1 + low + 1j * height, 2 + low - 1j * height, 2.5 + low, 3 + low])
    lower, upper = wave(0.5, 0j), wave(0.3, 1.2j)
    return [(*lower, "wall"), ("line", 3 + 0j, 3 + 1.2j, "outflow"), *named(hole([upper]), "wall"),
            ("line", 1.2j, 0j, "inflow")]


def sector(holes=(1.1, 1.75)):
    """30 degrees of a perforated disc, with its centre."""
    end = 2.4 * cmath.exp(1j * math.pi / 6)
    outline = [("line", 0j, 2.4 + 0j, "from"), ("arc", 0j, 2.4, 2.4 + 0j, end, 1, "rim"), ("line", end, 0j, "to")]
    return [outline] + [hole(circle(radius * cmath.exp(1j * math.pi / 12), 0.14)) for radius in holes]


def tube_bank():
    """A row of tubes between two that are cut in half: each side has three parts, of different lengths."""
    def row(height, name):
        loop, start = [], 0j + height
        for k, (x, radius) in enumerate(((2, 0.4), (4.5, 0.7))):
            a, b = x - radius + height, x + radius + height
            loop += [("line", start, a, f"{name}_{k}"), ("arc", x + height, radius, a, b, 1 if height else -1, "tube")]
            start = b
        return loop + [("line", start, 6 + height, f"{name}_2")]
    below, above = row(0j, "below"), row(2j, "above")
    return [below + [("line", 6 + 0j, 6 + 2j, "outlet")] + hole(above) + [("line", 2j, 0j, "inlet")],
            hole(circle(3.2 + 1j, 0.3, "tube"))]


def wedges_in_plate():
    """A plate around two wedges that touch in a point, where the plate touches itself: drawn as three faces."""
    wedges = [polygon([0j, 2 - 1j, 2 + 0.5j]), polygon([0j, -2 + 0.8j, -1.5 - 0.6j])]
    return [("plate", [rectangle(-4 - 3j, 4 + 3j)] + [hole(wedge) for wedge in wedges]),
            *((f"wedge {k}", [wedge]) for k, wedge in enumerate(wedges))]


def finned_plate():
    """A base with three fins on its upper side, and a chip below it."""
    fins = [(f"fin {k}", [rectangle(x + 1j, x + 0.5 + 2.5j)]) for k, x in enumerate((1, 3, 5))]
    return [("base", [rectangle(0j, 6 + 1j)]), *fins, ("chip", [rectangle(2 - 0.5j, 4 + 0j)])]


def periodic_models():
    box, ring = periodic_box()
    blade_outline, blade = blade_passage()
    # The top is an arc: the bottom is straight.
    unequal = [("line", 0j, 2 + 0j, "bottom"), ("line", 2 + 0j, 2 + 1j, "right"),
               ("arc", 1 + 0j, math.sqrt(2), 2 + 1j, 1j, 1, "top"), ("line", 1j, 0j, "left")]
    layers = [("fluid", [[("line", 0j, 4 + 0j, "wall"), ("line", 4 + 0j, 4 + 1j, "right"), ("line", 4 + 1j, 1j),
                          ("line", 1j, 0j, "left")], hole(circle(1.3 + 0.55j, 0.2))]),
              ("solid", [[("line", 1j, 4 + 1j), ("line", 4 + 1j, 4 + 1.5j, "right"), ("line", 4 + 1.5j, 1.5j, "top"),
                          ("line", 1.5j, 1j, "left")]])]
    return {
        "periodic_box": sheet("periodic_box", [("box", [box, hole(ring)])]),
        "periodic_blade": sheet("periodic_blade", [("passage", [blade_outline, blade])]),
        "periodic_wave": sheet("periodic_wave", [("channel", [wavy_channel()])]),
        "periodic_sector": sheet("periodic_sector", [("disc", sector())]),
        "periodic_layers": sheet("periodic_layers", layers),
        "periodic_pin": sheet("periodic_pin", [("fluid", [box, hole(ring)]), ("pin", [ring])]),
        "periodic_bank": sheet("periodic_bank", [("fluid", tube_bank())]),
        "bad/periodic_unequal": sheet("periodic_unequal", [("plate", [unequal])]),
    }


def models():
    square = rectangle(-1 - 1j, 1 + 1j)
    gear_outline, cam_outline = gear(), cam()
    lower = [("line", 1 + 0j, -1 + 0j, "cut"), ("arc", 0j, 1, -1 + 0j, 1 + 0j, 1)]
    upper = [("line", -1 + 0j, 1 + 0j, "cut"), ("arc", 0j, 1, 1 + 0j, -1 + 0j, 1)]
    channel = [("line", 0j, 22 + 0j, "wall"), ("line", 22 + 0j, 22 + 4.1j, "outlet"), ("line", 22 + 4.1j, 4.1j, "wall"),
               ("line", 4.1j, 0j, "inlet")]
    box = [("line", -1.5 - 1.5j, 2.5 - 1.5j), ("line", 2.5 - 1.5j, 2.5 + 1.5j, "outlet"), ("line", 2.5 + 1.5j, -1.5 + 1.5j),
           ("line", -1.5 + 1.5j, -1.5 - 1.5j, "inlet")]
    plate = rectangle(0j, 3 + 2j)
    return {
        "disc_in_square": sheet("disc_in_square", [("matrix", [square, hole(circle(0, 0.4))]),
                                                   ("fibre", [circle(0, 0.4, 0.4j)])], own=True),
        "nested_rings": sheet("nested_rings", [("core", [circle(0, 1)]), ("inner", [circle(0, 1.5), hole(circle(0, 1))]),
                                               ("outer", [circle(0, 2), hole(circle(0, 1.5))])]),
        "chequerboard_2_hole": sheet("chequerboard_2_hole", board(2, 0.4)),
        "chequerboard_4_hole": sheet("chequerboard_4_hole", board(4, 0.4)),
        "t_joint": sheet("t_joint", t_joint(0)),
        "t_joint_open": sheet("t_joint_open", t_joint(4e-6), own=True),
        "coated_gear": sheet("coated_gear", [("gear", [gear_outline, hole(circle(0, 3))]),
                                             ("coating", [offset(gear_outline, 0.2), hole(gear_outline)])]),
        "pipe_wall": sheet("pipe_wall", [("wall", [circle(0, 1), hole(circle(0.1, 0.7))]),
                                         ("fluid", [circle(0.1, 0.7, 0.1 - 0.7j)])], own=True),
        "voronoi_20": sheet("voronoi_20", [(f"cell_{k}", [polygon(cell)]) for k, cell in
                                           enumerate(with_corners(voronoi()))]),
        "finned_plate": sheet("finned_plate", finned_plate(), own=True),
        "wedges_in_plate": sheet("wedges_in_plate", wedges_in_plate()),
        "half_disc_cut": sheet("half_disc_cut", [("upper", [upper]), ("lower", [lower])]),
        "aerofoil_wake": sheet("aerofoil_wake", [("air", [box, naca0012()])], [("line", 1 + 0j, 2.5 + 0j, "wake")]),
        "plate_curve": sheet("plate_curve", [("plate", [plate])], [("arc", 1.5 + 0.4j, 0.9, 2.2 + 0.4j + 0.5656854249492381j,
                                                                    0.8 + 0.4j + 0.5656854249492381j, 1, "baffle")]),
        "plate_circle": sheet("plate_circle", [("plate", [plate])], [("circle", 1.5 + 1j, 0.6)]),
        "plate_crack": sheet("plate_crack", [("plate", [plate])], [("line", 1.5 + 0j, 1.5 + 0.9j, "crack")]),
        "coated_cam": sheet("coated_cam", [("cam", [cam_outline, hole(circle(0, 5))]),
                                           ("coating", [offset(cam_outline, 0.4), hole(cam_outline)]),
                                           ("bush", [circle(0, 5), hole(circle(0, 4))])]),
        "layered_cable": sheet("layered_cable", cable()),
        "layered_seal": sheet("layered_seal", seal()),
        "layered_beam": sheet("layered_beam", beam(), own=True),
        "pins": sheet("pins", pins(), own=True),
        "pin_in_channel": sheet("pin_in_channel", [("fluid", [channel, [("circle", 4 + 2j, 0.5, -1, "pin surface")]]),
                                                   ("pin", [circle(4 + 2j, 0.5)])]),
        "bad/dangling": sheet("dangling", [("plate", [plate])], [("line", 1.5 + 0.0005j, 1.5 + 1j)]),
        **periodic_models(),
        "bad/overlap": sheet("overlap", [("one", [rectangle(0j, 2 + 1j)]), ("two", [rectangle(1.5 + 0.25j, 3 + 0.75j)])]),
        "bad/disc_on_square": sheet("disc_on_square", [("plate", [square]), ("disc", [circle(0, 0.4)])]),
        "bad/twice": sheet("twice", [("one", [square]), ("two", [square])], own=True),
        "bad/gap": sheet("gap", [("left", [rectangle(0j, 1 + 1j)]), ("right", [rectangle(1.0002 + 0j, 2 + 1j)])]),
        "bad/gap_around": sheet("gap_around", [("matrix", [square, hole(circle(0, 0.4))]),
                                               ("fibre", [circle(0, 0.3995)])]),
        "bad/crevice": sheet("crevice", [("base", [rectangle(0j, 2 + 1j)]),
                                         ("left", [polygon([1j, 1 + 1.0004j, 1 + 2j, 2j])]),
                                         ("right", [rectangle(1 + 1j, 2 + 2j)])], own=True),
        "bad/disjoint": sheet("disjoint", [("one", [rectangle(0j, 1 + 1j)]), ("two", [rectangle(1.5 + 0j, 2 + 1j)])]),
        "bad/corner_contact": sheet("corner_contact", [("one", [rectangle(0j, 1 + 1j)]), ("two", [rectangle(1 + 1j, 2 + 2j)])]),
    }


def rays(centre, *curves):
    """Lines from a point: angle in degrees, length, name."""
    return [("line", centre, centre + length * cmath.exp(1j * math.radians(angle)), name) for angle, length, name in curves]


def cracks():
    """Plates with curves inside that meet at acute angles or along each other, or at which a region touches itself."""
    plate, holed = [rectangle(0j, 6 + 4j)], [rectangle(0j, 6 + 4j), hole(circle(2 + 2j, 0.7))]
    centre, edge = 3 + 2j, 2 + 2j + 0.7 * cmath.exp(1j * math.radians(60))
    a, b = centre + 1.3 * cmath.exp(1j * math.radians(25)), centre + 1.1 * cmath.exp(1j * math.radians(70))
    corner = [("line", centre, a, "patch"), ("line", a, b, "patch"), ("line", b, centre, "patch")]
    legs = [("line", centre, 1 + 0j, "leg"), ("line", centre, 5.5 + 0j, "leg")]
    return {
        "cracks_x": (plate, [("line", 2 * centre - z, z, name) for _, _, z, name in
                             rays(centre, (10, 1.6, "one"), (45, 1.4, "two"))]),
        "cracks_y": (plate, rays(centre, (0, 1.5, "stem"), (145, 1.2, "upper"), (180, 1.4, "lower"))),
        "crack_from_hole": (holed, rays(edge, (120, 1.1, "crack"))),
        "crack_askew": (holed, rays(edge, (85, 1.1, "crack"))),
        "cracks_along": (plate, [("line", 1 + 2j, 5 + 2j, "long"), ("line", 2.5 + 2j, 3.7 + 2j, "short")]),
        "cracks_equal": (plate, [("line", 1 + 2j, 5 + 2j, "one"), ("line", 5 + 2j, 1 + 2j, "two")]),
        "patch_touching": (plate, corner + legs),
        "patches_touching": (plate, corner + [("line", *(2 * centre - z for z in edge_[1:3]), "patch") for edge_ in corner]),
    }


def doubled(name, lines, is_closed):
    """A plate with an inner wire of these lines that bounds nothing: forth and back, or forth only."""
    step = Sheet()
    loops = [rectangle(0j, 2 + 1j), [("line", a, b) for a, b in lines]]
    if is_closed:
        loops[1] += [("line", b, a) for a, b in reversed(lines)]
    step.region("plate", loops)
    step.product(name)
    return step.text(name)


def slit():
    """A plate whose outline runs into it along a line and back."""
    step = Sheet()
    step.region("plate", [[("line", 0j, 1 + 0.5j), ("line", 1 + 0.5j, 0j)] + rectangle(0j, 2 + 1j)])
    step.product("slit")
    return step.text("slit")


def two_planes():
    """The floor and a wall of a box, which share an edge."""
    step = Sheet()
    step.region("floor", [rectangle(0j, 2 + 1j)])
    step.frame = (0, 0, 0), (1, 0, 0), (0, 0, 1)
    step.shared, step.points, step.vertices = {}, {}, {}
    step.region("wall", [rectangle(0j, 2 + 1j)])
    step.frame = None
    step.product("two_planes")
    return step.text("two_planes")


def iges_disc():
    """The disc in the square again, in IGES, as two trimmed surfaces on levels of their own."""
    iges = Iges()
    plane = iges.add(108, 0.0, 0.0, 1.0, 0.0, 0, 0.0, 0.0, 0.0, 0.0)
    corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
    sides = [iges.add(110, *a, 0.0, *b, 0.0) for a, b in zip(corners, corners[1:] + corners[:1])]
    outline = iges.add(142, 0, plane, 0, iges.add(102, 4, *sides), 2)
    hole_of_square = iges.add(142, 0, plane, 0, iges.add(100, 0.0, 0.0, 0.0, 0.4, 0.0, 0.4, 0.0), 2)
    iges.add(144, plane, 1, 1, outline, hole_of_square, level=1)
    disc = iges.add(142, 0, plane, 0, iges.add(100, 0.0, 0.0, 0.0, 0.0, 0.4, 0.0, 0.4), 2)
    iges.add(144, plane, 1, 0, disc, level=2)
    return iges.text("disc_in_square")


def link(gap=0.0):
    """A chain link without a face: its curves in no order, and drawn in either direction."""
    return [("line", -2 + 1j, 2 + 1j, "flank"), ("circle", -2 + 0j, 0.5),
            ("arc", 2 + 0j, 1, 2 - 1j, 2 + 1j, 1, "head"), ("circle", 2 + 0j, 0.5),
            ("arc", -2 + 0j, 1, -2 + 1j, -2 - 1j, 1, "head"), ("line", 2 - 1j, -2 + gap - 1j, "flank")]


def loose(name, curves):
    """Curves that lie beside no face."""
    step = Sheet()
    for curve in curves:
        step.curve(*curve)
    step.wireframe(name)
    return step.text(name)


def iges_loose():
    """Three sides of a square in no order, the fourth a half circle."""
    iges = Iges()
    iges.add(110, 3.0, 0.0, 0.0, 3.0, 2.0, 0.0, level=3)
    iges.add(110, 0.0, 0.0, 0.0, 3.0, 0.0, 0.0)
    iges.add(100, 0.0, 0.0, 1.0, 0.0, 2.0, 0.0, 0.0)
    iges.add(110, 3.0, 2.0, 0.0, 0.0, 2.0, 0.0)
    return iges.text("loose_curves")


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))
    os.makedirs(os.path.join(folder, "bad"), exist_ok=True)
    for name, text in {**models(), **{name: sheet(name, [("plate", loops)], curves) for name, (loops, curves) in
                                      cracks().items()}, "slit": slit(), "bad/two_planes": two_planes(),
                       "loose_curves": loose("loose_curves", link()), "bad/loose_gap": loose("loose_gap", link(0.001)),
                       "bad/loose_branch": loose("loose_branch", [*link(), ("line", 2 + 1j, 3 + 2j)]),
                       "inner_curve": doubled("inner_curve", [(0.5 + 0.5j, 1 + 0.5j)], True),
                       "open_inner_wire": doubled("open_inner_wire", [(0.5 + 0.5j, 1 + 0.5j), (1 + 0.5j, 1.2 + 0.7j)],
                                                  False)}.items():
        with open(os.path.join(folder, name + ".step"), "w", encoding="ascii") as file:
            file.write(text)
    with open(os.path.join(folder, "disc_in_square.iges"), "w", encoding="ascii") as file:
        file.write(iges_disc())
    with open(os.path.join(folder, "loose_curves.iges"), "w", encoding="ascii") as file:
        file.write(iges_loose())


if __name__ == "__main__":
    main()
