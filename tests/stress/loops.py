"""Curves, loops and checks of random shapes, for families.py and parts.py beside this file.

Points are complex numbers, loops as in tests/data/step_text.py: the outline counter-clockwise, holes clockwise.
"""
import cmath
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "data"))
from step_text import basis, polygon  # noqa: E402


class Rejected(Exception):
    """The numbers drawn give no shape that is worth a test."""


def unit(angle):
    return cmath.exp(1j * angle)


def whole(rng, low, high):
    return low + int(rng.random() * (high + 1 - low))


# ------------------------------------------------------------------------------------------------ curves

def rounded_polygon(corners, radii):
    """polygon() with radii that leave a part of every side."""
    loop = polygon(corners, radii)
    lines = [piece for piece in loop if piece[0] == "line"]
    for (_, a, b), corner, following in zip(lines, corners, corners[1:] + corners[:1]):
        if ((b - a) * (following - corner).conjugate()).real <= 0:
            raise Rejected
    return loop


def closed_spline(poles):
    """The periodic cubic with one pole per unit of its parameter, as a clamped spline."""
    n = len(poles)
    before, first, second = poles[-1], poles[0], poles[1]
    start = (before + 4 * first + second) / 6
    inner = [(2 * first + second) / 3] + poles[1:] + [(2 * first + before) / 3]
    return [("spline", [start] + inner + [start], [0.0] * 3 + [float(t) for t in range(n + 1)] + [float(n)] * 3)]


def star(rng, sides, low, high):
    """Poles at growing angles."""
    return [rng.uniform(low, high) * unit(2 * math.pi * (k + rng.uniform(-0.25, 0.25)) / sides) for k in range(sides)]


def circle(centre, radius):
    """A hole."""
    return [("circle", centre, radius, -1)]


def disc(radius):
    return [("circle", 0j, radius, 1)]


def hole(corners, radii=None):
    """Corners counter-clockwise."""
    return polygon(corners[::-1], radii and radii[::-1])


def box(centre, length, width, turn):
    """Corners of a rectangle, counter-clockwise."""
    return [centre + unit(turn) * complex(x * length / 2, y * width / 2)
            for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def rounded_box(centre, length, width, turn):
    """A stadium: the short sides are half circles."""
    a, b, c, d = box(centre, length - width, width, turn)
    return [("line", a, b), ("arc", (b + c) / 2, width / 2, b, c, 1),
            ("line", c, d), ("arc", (d + a) / 2, width / 2, d, a, 1)]


def backwards(loop):
    """The same loop as a hole."""
    back = []
    for kind, *rest in loop[::-1]:
        if kind == "line":
            back.append(("line", rest[1], rest[0]))
        elif kind == "arc":
            centre, radius, a, b, side = rest
            back.append(("arc", centre, radius, b, a, -side))
        elif kind == "circle":
            back.append(("circle", rest[0], rest[1], -rest[2]))
        else:
            poles, knots = rest
            back.append(("spline", poles[::-1], [knots[-1] - t for t in knots[::-1]]))
    return back


def moved(loop, factor, shift):
    """z -> factor z + shift."""
    def at(z):
        return factor * z + shift

    size = abs(factor)
    result = []
    for kind, *rest in loop:
        if kind == "line":
            result.append(("line", at(rest[0]), at(rest[1])))
        elif kind == "arc":
            result.append(("arc", at(rest[0]), rest[1] * size, at(rest[2]), at(rest[3]), rest[4]))
        elif kind == "circle":
            result.append(("circle", at(rest[0]), rest[1] * size, rest[2]))
        else:
            result.append(("spline", [at(p) for p in rest[0]], rest[1]))
    return result


# ------------------------------------------------------------------------------------------------ checks

def points_of(edge, spacing):
    """Along the edge, the last point left out."""
    kind, *rest = edge
    if kind == "line":
        a, b = rest
        count = max(1, math.ceil(abs(b - a) / spacing))
        return [a + (b - a) * k / count for k in range(count)]
    if kind == "spline":
        poles, knots = rest
        length = sum(abs(q - p) for p, q in zip(poles, poles[1:]))
        count = max(16, math.ceil(length / spacing))
        result = []
        for k in range(count):
            first, values = basis(knots, knots[0] + (knots[-1] - knots[0]) * k / count)
            result.append(sum(value * pole for value, pole in zip(values, poles[first:])))
        return result
    if kind == "circle":
        centre, radius, side = rest
        start, turn = 0.0, 2 * math.pi * side
    else:
        centre, radius, a, b, side = rest
        start = cmath.phase(a - centre)
        turn = side * (side * (cmath.phase(b - centre) - start) % (2 * math.pi))
    count = max(4, math.ceil(abs(turn) * radius / spacing))
    return [centre + radius * unit(start + turn * k / count) for k in range(count)]


def check_clearance(loops, gap, smooth=False):
    """Points of the boundary that are nearer than the gap lie at most 4 gaps from each other along one loop; where all
    is smooth, no bend is sharper than half the gap."""
    spacing, cells = gap / 3, {}
    for which, loop in enumerate(loops):
        points = [p for edge in loop for p in points_of(edge, spacing)]
        places, along = [], 0.0
        for p, q in zip(points, points[1:] + points[:1]):
            places.append(along)
            along += abs(q - p)
        if smooth:
            for p, q, r in zip(points, points[1:] + points[:1], points[2:] + points[:2]):
                if abs(cmath.phase((r - q) / (q - p))) > 0.7 * max(abs(q - p) / spacing, 0.2):
                    raise Rejected
        for p, place in zip(points, places):
            x, y = math.floor(p.real / gap), math.floor(p.imag / gap)
            for i in (x - 1, x, x + 1):
                for j in (y - 1, y, y + 1):
                    for other, near, q in cells.get((i, j), ()):
                        if abs(q - p) >= gap:
                            continue
                        apart = abs(place - near)
                        if other != which or min(apart, along - apart) > 4 * gap:
                            raise Rejected
            cells.setdefault((x, y), []).append((which, place, p))


def distance_to_side(p, a, b):
    t = ((p - a) / (b - a)).real
    return abs(p - (a + (b - a) * min(max(t, 0), 1)))


def cross(a, b):
    return a.real * b.imag - a.imag * b.real


def sides_cross(a, b, c, d):
    return cross(b - a, c - a) * cross(b - a, d - a) < 0 and cross(d - c, a - c) * cross(d - c, b - c) < 0


def corner_angles(corners):
    """Inner angles in degrees of corners that go counter-clockwise."""
    n = len(corners)
    return [math.degrees(cmath.phase((corners[i - 1] - corners[i]) / (corners[(i + 1) % n] - corners[i]))) % 360
            for i in range(n)]


def area(corners):
    return sum(cross(a, b) for a, b in zip(corners, corners[1:] + corners[:1])) / 2


def inside(p, points):
    """Of a polygon, by crossings of a ray."""
    result = False
    for a, b in zip(points, points[1:] + points[:1]):
        if (a.imag > p.imag) != (b.imag > p.imag) and p.real < a.real + (p.imag - a.imag) / (b - a).imag * (b - a).real:
            result = not result
    return result
