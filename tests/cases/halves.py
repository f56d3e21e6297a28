#!/usr/bin/env python3
"""Bodies in far fields and channels, as one half above the x axis and as a whole.

    halves.py NAME       writes half.step and whole.step; quarter, quarter_disc: quarter.step
    halves.py compare HALF.crit.json WHOLE.crit.json TOLERANCE
                         the nodes of the half must be those of the whole above the axis, and every valence on the axis
                         half of that of the whole
"""
import json
import math
import os
import sys

for folder in ("data", "data/regions"):
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", folder))
from make_regions import sheet
from step_text import cubic_through, step_text


def line(a, b, name):
    return ("line", complex(a), complex(b), name)


def aerofoil(last=0.1036, points=40):
    """From nose to tail; with last = 0.1015 the tail is blunt."""
    xs = [(1 - math.cos(math.pi * k / points)) / 2 for k in range(points + 1)]
    z = [complex(x, 0.6 * (0.2969 * math.sqrt(x) - 0.126 * x - 0.3516 * x**2 + 0.2843 * x**3 - last * x**4))
         for x in xs]
    z[-1] = z[-1] if last < 0.103 else 1 + 0j
    lengths = [0.0]
    for a, b in zip(z, z[1:]):
        lengths.append(lengths[-1] + abs(b - a))
    slope = 0.6 * (0.2969 / 2 - 0.126 - 2 * 0.3516 + 3 * 0.2843 - 4 * last)
    poles, knots = cubic_through(z, lengths, 1j, complex(1, slope) / abs(complex(1, slope)))
    return [("spline", poles, knots, "body")] + ([] if z[-1] == 1 else [line(z[-1], 1, "body")])


def ellipse(a, b, points=24):
    angles = [math.pi * k / points for k in range(points + 1)]
    z = [complex(-a * math.cos(t), b * math.sin(t)) for t in angles]
    z[-1] = complex(a)
    poles, knots = cubic_through(z, angles, complex(0, b), complex(0, -b))
    return [("spline", poles, knots, "body")]


def cylinder(radius):
    return [("arc", 0j, radius, complex(-radius), complex(radius), -1, "body")]


def square(half):
    corners = [-half, -half + 1j * half, half + 1j * half, half]
    return [line(a, b, "body") for a, b in zip(corners, corners[1:])]


def c_outline(r, name="farfield"):
    return [line(1 + r, 1 + r + 1j * r, name), line(1 + r + 1j * r, 1 + 1j * r, name),
            ("arc", 1 + 0j, r, 1 + 1j * r, 1 - r + 0j, 1, name)]


def box(left, right, height, *names):
    corners = [right, right + 1j * height, left + 1j * height, left]
    return [line(a, b, name) for a, b, name in zip(corners, corners[1:], names)]


def disc(radius):
    return ("arc", 0j, radius, complex(radius), complex(-radius), 1, "wall")


FAR = ("farfield",) * 3
CASES = {
    "aerofoil_c": (aerofoil(), c_outline(10)),
    "blunt_c": (aerofoil(0.1015), c_outline(10)),
    "aerofoil_box": (aerofoil(), box(-4, 5, 4, *FAR)),
    "aerofoil_o": (aerofoil(), [("arc", 0j, 10, 10 + 0j, -10 + 0j, 1, "farfield")]),
    "blunt_o": (aerofoil(0.1015), [("arc", 0j, 10, 10 + 0j, -10 + 0j, 1, "farfield")]),
    "ellipse_box": (ellipse(2, 1), box(-10, 10, 10, *FAR)),
    "ellipse_o": (ellipse(2, 1), [("arc", 0j, 10, 10 + 0j, -10 + 0j, 1, "farfield")]),
    "thin_ellipse": (ellipse(1, 0.15), [("arc", 0j, 3, 3 + 0j, -3 + 0j, 1, "far")]),
    "square_box": (square(1), box(-10, 10, 10, *FAR)),
    "cylinder_channel": (cylinder(0.5), box(-4, 8, 2, "outlet", "wall", "inlet")),
    "disc": ([], [disc(1)]),
    "ellipse": ([], [("spline", ellipse(2, 1)[0][1][::-1], [-t for t in ellipse(2, 1)[0][2][::-1]], "wall")]),
    "channel": ([], box(-4, 8, 2, "outlet", "wall", "inlet")),
    "pair": (cylinder(1), box(-6, 10, 6, *FAR)),
}


def ends(edge):
    if edge[0] == "arc":
        return edge[3], edge[4]
    return (edge[1], edge[2]) if edge[0] == "line" else (edge[1][0], edge[1][-1])


def reflected(edge, mirror):
    if edge[0] == "line":
        return ("line", mirror(edge[2]), mirror(edge[1]), *edge[3:])
    if edge[0] == "arc":
        return ("arc", mirror(edge[1]), edge[2], mirror(edge[4]), mirror(edge[3]), *edge[5:])
    knots = edge[2]
    return ("spline", [mirror(z) for z in reversed(edge[1])], [knots[0] + knots[-1] - t for t in reversed(knots)],
            *edge[3:])


def with_image(edges):
    return edges + [reflected(edge, lambda z: z.conjugate()) for edge in reversed(edges)]


def half(body, outer):
    start, end = ends(outer[0])[0], ends(outer[-1])[1]
    if not body:
        return [[line(end, start, "symmetry"), *outer]]
    return [[line(ends(body[-1])[1], start, "symmetry"), *outer, line(end, ends(body[0])[0], "symmetry"), *body]]


def whole(body, outer):
    return [with_image(loop) for loop in (outer, body) if loop]


def quarter_plate():
    """With a quarter of a round hole."""
    return [[line(1, 4, "symmetry_x"), line(4, 4 + 4j, "wall"), line(4 + 4j, 4j, "wall"), line(4j, 1j, "symmetry_y"),
             ("arc", 0j, 1, 1j, 1 + 0j, -1, "hole")]]


def quarter_disc():
    return [[line(0, 1, "symmetry_x"), ("arc", 0j, 1, 1 + 0j, 1j, 1, "wall"), line(1j, 0, "symmetry_y")]]


def inclusion():
    """A plate around a disc, of another region, on the axis."""
    around = half(cylinder(1), box(-3, 3, 2, "wall", "wall", "wall"))
    inside = half([], [disc(1)])
    plate, whole_disc = with_image(box(-3, 3, 2, "wall", "wall", "wall")), with_image([disc(1)])
    hole = [reflected(edge, lambda z: z) for edge in reversed(whole_disc)]
    hole = [(*edge[:5], -1, edge[6]) for edge in hole]
    return {"half": [("plate", around), ("disc", inside)], "whole": [("plate", [plate, hole]), ("disc", [whole_disc])]}


def write(name):
    quarters = {"quarter": quarter_plate, "quarter_disc": quarter_disc}
    if name in quarters:
        with open("quarter.step", "w", encoding="ascii") as file:
            file.write(step_text(name, quarters[name]()))
        return
    if name == "inclusion":
        for part, regions in inclusion().items():
            with open(f"{part}.step", "w", encoding="ascii") as file:
                file.write(sheet(part, regions))
        return
    body, outer = CASES[name]
    halves, wholes = half(body, outer), whole(body, outer)
    if name == "pair":  # a second body off the axis
        halves.append([("circle", 4 + 3j, 1, -1, "body")])
        wholes += [[("circle", 4 + 3j, 1, -1, "body")], [("circle", 4 - 3j, 1, -1, "body")]]
    for part, loops in (("half", halves), ("whole", wholes)):
        with open(f"{part}.step", "w", encoding="ascii") as file:
            file.write(step_text(name, loops))


def compare(half_file, whole_file, tolerance):
    halves, wholes = json.load(open(half_file)), json.load(open(whole_file))

    def nodes(points, key, above):
        return [(complex(*p["position"]), p["valence"]) for p in points[key] if above(p["position"][1])]

    expected = nodes(wholes, "critical_points", lambda y: y > tolerance)
    found = nodes(halves, "critical_points", lambda y: True)
    assert len(found) == len(expected), f"{len(found)} nodes, not {len(expected)}"
    for z, valence in expected:
        assert any(abs(z - w) < tolerance and valence == v for w, v in found), f"no node of valence {valence} at {z}"
    corners = nodes(wholes, "corners", lambda y: True) + nodes(wholes, "boundary_nodes", lambda y: True)
    corners += nodes(wholes, "critical_points", lambda y: abs(y) <= tolerance)
    for key in ("corners", "boundary_nodes"):
        for z, valence in nodes(halves, key, lambda y: True):
            there = [v for w, v in corners if abs(z - w) < tolerance] or [2]
            assert there == [valence * (2 if z.imag <= tolerance else 1)], f"{valence} blocks at {z}, whole {there}"


if sys.argv[1] == "compare":
    compare(sys.argv[2], sys.argv[3], float(sys.argv[4]))
else:
    write(sys.argv[1])
