#!/usr/bin/env python3
"""Random shapes from fixed seeds, to stress the chain; `run` beside this file runs it on them.

    families.py [--set shapes|parts] [--sample] FOLDER [NAME...]     writes all of a set, its sample of 50, or the named

The set "shapes" has the 500 below, the set "parts" 1,000 faces as they come from CAD programs (parts.py). A shape's
name is its family and a number, polygon_017, and the name is its seed: a family can grow and no shape changes. Every
shape is checked before it counts: no side crosses another, and sides that are not neighbours keep a clearance. What is
drawn and fails is drawn again. Half of the shapes lie straight, so that ties are exact, the others are turned; sizes go
from a tenth to a hundred. Every tenth shape of each family belongs to the sample.

  smooth   120  closed cubic splines, star-shaped or twisted, 0 to 5 holes, round or smooth
  polygon  120  4 to 12 straight sides, corners from 15 to 345 degrees
  plate     80  rectangles and discs with 4 to 100 round holes
  spiral    40  strips of 1 to 3 turns: round with square or round ends, tapered, rectangular
  comb      40  3 to 12 teeth on a bar: upright, slanted, rounded, on both sides
  tangent   50  circles that nearly touch: eccentric annuli, holes beside holes, beside a side, beside an arc
  slit      50  thin cavities and notches: stadium, rectangle, V, ellipse, several

Plain Python; the same bytes every time. Lengths in millimetres, points are complex numbers, loops as in step_text.
"""
import argparse
import math
import os
import random

import parts
from loops import (Rejected, area, backwards, box, check_clearance, circle, closed_spline, corner_angles, disc,
                   distance_to_side, hole, inside, moved, points_of, rounded_box, sides_cross, star, unit, whole)
from step_text import cubic_through, polygon, rectangle, step_text

COUNTS = {"smooth": 120, "polygon": 120, "plate": 80, "spiral": 40, "comb": 40, "tangent": 50, "slit": 50}


# ------------------------------------------------------------------------------------------------ families

def smooth(rng, number):
    gap = 0.06
    twist = rng.uniform(-1.2, 1.2) if number % 2 else 0.0
    outline = [z * unit(twist * abs(z) ** 2) for z in star(rng, whole(rng, 5, 12), 0.5, 1.3)]
    loops = [closed_spline(outline)]
    check_clearance(loops, gap, True)
    rim, holes = points_of(loops[0][0], gap), []
    for _ in range(number % 6):
        for _ in range(200):
            centre = complex(rng.uniform(-1, 1), rng.uniform(-1, 1))
            radius = rng.uniform(0.08, 0.3)
            if rng.random() < 0.5:
                one = circle(centre, radius)
            else:
                poles = [centre + z for z in star(rng, whole(rng, 5, 8), 0.6 * radius, 1.3 * radius)]
                one = backwards(closed_spline(poles))
            if not inside(centre, rim):
                continue
            first = points_of(one[0], gap)
            if any(inside(first[0], other) or inside(other[0], first) for other in holes):
                continue
            try:
                check_clearance(loops + [one], gap, True)
            except Rejected:
                continue
            loops.append(one)
            holes.append(first)
            break
        else:
            raise Rejected
    return loops


def uncrossed(corners):
    """The same corners in a sequence whose sides do not cross: crossing sides are exchanged until there are none."""
    n = len(corners)
    for _ in range(1000):
        for i in range(n):
            for j in range(i + 2, n - (i == 0)):
                if sides_cross(corners[i], corners[i + 1], corners[j], corners[(j + 1) % n]):
                    corners = corners[:i + 1] + corners[i + 1:j + 1][::-1] + corners[j + 1:]
                    break
            else:
                continue
            break
        else:
            return corners
    raise Rejected


def polygon_shape(rng, number):
    sides = whole(rng, 4, 12)
    corners = uncrossed([complex(rng.uniform(-1, 1), rng.uniform(-1, 1)) for _ in range(sides)])
    if area(corners) < 0:
        corners = corners[::-1]
    angles = corner_angles(corners)
    if min(angles) < 15 or max(angles) > 345 or any(abs(angle - 180) < 2 for angle in angles):
        raise Rejected
    if number % 3 == 1 and min(angles) > 40 or number % 3 == 2 and max(angles) < 300:
        raise Rejected
    for i in range(sides):
        a, b = corners[i], corners[(i + 1) % sides]
        if abs(b - a) < 0.12:
            raise Rejected
        for j in range(sides):
            if j not in (i, (i + 1) % sides) and distance_to_side(corners[j], a, b) < 0.08:
                raise Rejected
    return [polygon(corners)]


def plate(rng, number):
    count = round(4 + 96 * number / 79)
    width, height = rng.uniform(1, 2), 1.0
    is_round = number % 4 == 3
    room = math.pi / 4 if is_round else width * height
    largest = rng.uniform(0.15, 0.25) * math.sqrt(room / count)
    smallest = largest * (1.0 if rng.random() < 0.5 else 0.4)
    gap = rng.uniform(0.3, 0.8) * largest
    holes = []
    for _ in range(count):
        for _ in range(2000):
            radius = rng.uniform(smallest, largest)
            centre = complex(rng.uniform(-width, width) / 2, rng.uniform(-height, height) / 2)
            need = radius + gap
            if is_round:
                fits = abs(centre) + need < 0.5
            else:
                fits = abs(centre.real) + need < width / 2 and abs(centre.imag) + need < height / 2
            if fits and all(abs(centre - c) > need + r for c, r in holes):
                holes.append((centre, radius))
                break
        else:
            raise Rejected
    outline = disc(0.5) if is_round else rectangle(-complex(width, height) / 2, complex(width, height) / 2)
    return [outline] + [circle(c, r) for c, r in holes]


def round_spiral(rng, ends_round, taper):
    """The strip between two offsets of r = r0 + t / 2 pi."""
    turns, width = rng.uniform(1, 3), rng.uniform(0.3, 0.7)
    first, last = rng.uniform(0.7, 1.5), 2 * math.pi * turns
    pitch = 1 / (2 * math.pi)

    def offset(t, side):
        half = width / 2 * (1 + taper * (t / last - 0.5))
        direction = complex(pitch, first + pitch * t)
        return unit(t) * (first + pitch * t + side * half * direction / abs(direction) * -1j)

    def derivative(t, side):
        return (offset(t + 1e-5, side) - offset(t - 1e-5, side)) / 2e-5

    parameters = [last * k / math.ceil(last / 0.3) for k in range(math.ceil(last / 0.3) + 1)]
    rims = {side: cubic_through([offset(t, side) for t in parameters], parameters, derivative(0, side),
                                derivative(last, side)) for side in (1, -1)}

    def end(a, b):
        return ("arc", (a + b) / 2, abs(b - a) / 2, a, b, 1) if ends_round else ("line", a, b)

    outer, inner = ("spline", *rims[1]), backwards([("spline", *rims[-1])])[0]
    return [[outer, end(outer[1][-1], inner[1][0]), inner, end(inner[1][-1], outer[1][0])]]


def square_spiral(rng):
    """A strip of one width along a path of right angles, its arms one apart."""
    width, legs = rng.uniform(0.3, 0.7), whole(rng, 5, 12)
    path, direction = [0j], 1 + 0j
    for k in range(legs):
        path.append(path[-1] + direction * (k // 2 + 1 + rng.uniform(0, 0.2) * (k == legs - 1)))
        direction *= 1j
    left, right = [], []
    for i, z in enumerate(path):
        into = path[i] - path[i - 1] if i else path[1] - path[0]
        out = path[i + 1] - path[i] if i < legs else into
        into, out = into / abs(into), out / abs(out)
        corner = into * 1j if into == out else (into + out) * 1j
        left.append(z + corner * width / 2)
        right.append(z - corner * width / 2)
    return [polygon(right + left[::-1])]


def spiral(rng, number):
    kind = number % 4
    if kind == 3:
        return square_spiral(rng)
    return round_spiral(rng, kind == 1, rng.uniform(-0.6, 0.6) if kind == 2 else 0.0)


def teeth(rng, count, slant):
    """Corners from left to right along the upper edge of a bar, and the bar's length."""
    x, corners = rng.uniform(0.1, 0.5), []
    for _ in range(count):
        width, length, gap = rng.uniform(0.1, 0.4), rng.uniform(0.3, 1.5), rng.uniform(0.1, 0.4)
        tip = complex(slant * length, length)
        corners += [complex(x, 0), complex(x, 0) + tip, complex(x + width, 0) + tip, complex(x + width, 0)]
        x += width + gap
    return corners, x + rng.uniform(0, 0.3)


def comb(rng, number):
    kind = number % 4
    bar = rng.uniform(0.15, 0.5)
    upper, length = teeth(rng, whole(rng, 3, 12), rng.uniform(-0.6, 0.6) if kind == 1 else 0.0)
    below = []
    if kind == 3:
        lower, other = teeth(rng, whole(rng, 3, 8), 0.0)
        length = max(length, other)
        below = [z.conjugate() - 1j * bar for z in lower]
    corners = [-1j * bar] + below + [complex(length, -bar), complex(length, 0)] + upper[::-1] + [0j]
    radii = None
    if kind == 2:
        radii = [rng.uniform(0.01, 0.045) for _ in corners]
    loops = [polygon(corners, radii)]
    check_clearance(loops, 0.02)
    return loops


def tangent(rng, number):
    kind, gap = number % 5, 10 ** rng.uniform(-2.7, -1)
    if kind == 0:  # eccentric annulus
        radius = rng.uniform(0.2, 0.7)
        return [disc(1.0), circle((1 - radius - gap) * unit(rng.uniform(0, 6.28)), radius)]
    plain = rectangle(-1.5 - 1j, 1.5 + 1j)
    if kind == 1:  # hole beside hole
        a, b = rng.uniform(0.15, 0.4), rng.uniform(0.15, 0.4)
        turn, middle = unit(rng.uniform(0, 6.28)), complex(rng.uniform(-0.4, 0.4), rng.uniform(-0.1, 0.1))
        return [plain, circle(middle - turn * (a + gap / 2), a), circle(middle + turn * (b + gap / 2), b)]
    if kind == 2:  # hole beside a side, perhaps beside two
        radius = rng.uniform(0.2, 0.6)
        x = rng.uniform(-0.7, 0.7) if rng.random() < 0.7 else 1.5 - radius - gap
        return [plain, circle(complex(x, 1 - radius - gap), radius)]
    if kind == 3:  # two holes beside an arc and each other
        a = rng.uniform(0.3, 0.45)
        b = rng.uniform(0.2, 0.35)
        first, second = 1 - a - gap, 1 - b - gap
        between = math.acos((first**2 + second**2 - (a + b + gap) ** 2) / (2 * first * second))
        turn = rng.uniform(0, 6.28)
        return [disc(1.0), circle(first * unit(turn), a), circle(second * unit(turn + between), b)]
    radius, turn = rng.uniform(0.15, 0.25), unit(rng.uniform(0, 6.28))  # a chain of holes
    count = whole(rng, 3, 4)
    step = (2 * radius + gap) * turn
    holes = [(k - (count - 1) / 2) * step for k in range(count)]
    if abs(holes[0].imag) + radius > 1 - gap:
        raise Rejected
    return [plain] + [circle(z, radius) for z in holes]


def slit(rng, number):
    kind, thickness = number % 5, 10 ** rng.uniform(-2, -1)
    corner = complex(1.5, 1)
    plain = rectangle(-corner, corner)
    turn, length = rng.uniform(0, 3.14), rng.uniform(0.6, 1.4)
    middle = complex(rng.uniform(-0.4, 0.4), rng.uniform(-0.2, 0.2))
    if kind == 0:
        loops = [plain, backwards(rounded_box(middle, length, thickness, turn))]
    elif kind == 1:
        loops = [plain, hole(box(middle, length, thickness, turn))]
    elif kind == 2:  # a notch from the lower side, its foot flat, or a point of at least 15 degrees
        x, depth = rng.uniform(-1, 1), rng.uniform(0.5, 1.4)
        if rng.random() < 0.5:
            notch = [complex(x - thickness / 2, -1), complex(x - thickness / 2, depth - 1),
                     complex(x + thickness / 2, depth - 1), complex(x + thickness / 2, -1)]
        else:
            half = depth * math.tan(math.radians(rng.uniform(7.6, 12)))
            tip = complex(x + rng.uniform(-0.1, 0.1) * half, depth - 1)
            notch = [complex(x - half, -1), tip, complex(x + half, -1)]
        loops = [polygon([-corner] + notch + [corner.conjugate(), corner, -corner.conjugate()])]
    elif kind == 3:  # nearly an ellipse
        thickness = max(thickness, 0.02)
        poles = [middle + unit(turn) * complex(length / 2 * math.cos(t), thickness * math.sin(t))
                 for t in (2 * math.pi * k / 16 for k in range(16))]
        loops = [plain, backwards(closed_spline(poles))]
    else:
        loops = [plain]
        for _ in range(whole(rng, 2, 4)):
            place = complex(rng.uniform(-1, 1), rng.uniform(-0.5, 0.5))
            loops.append(backwards(rounded_box(place, rng.uniform(0.4, 1), thickness, rng.uniform(0, 3.14))))
    check_between(loops, 0.1)
    return loops


def check_between(loops, gap):
    """Loops keep the gap from each other; what a loop does to itself is its own matter."""
    sampled = [[p for edge in loop for p in points_of(edge, gap / 4)] for loop in loops]
    for i, points in enumerate(sampled):
        for others in sampled[:i]:
            if min(abs(p - q) for p in points for q in others) < gap:
                raise Rejected
        if i and not inside(points[0], sampled[0]):
            raise Rejected


FAMILIES = {"smooth": smooth, "polygon": polygon_shape, "plate": plate, "spiral": spiral, "comb": comb,
            "tangent": tangent, "slit": slit}


# ------------------------------------------------------------------------------------------------ shapes

SETS = {"shapes": COUNTS, "parts": parts.COUNTS}


def names(which="shapes"):
    return [f"{family}_{number:03d}" for family, count in SETS[which].items() for number in range(count)]


def sample(which="shapes"):
    """One of every ten shapes or twenty parts; the last digit moves on, so that all kinds of a family are met."""
    if which == "parts":
        return [name for name in names(which) if int(name[-3:]) % 20 == int(name[-3:]) // 20 * 7 % 20]
    return [name for name in names(which) if int(name[-1]) == (int(name[-3:]) // 10 * 3 + 1) % 10]


def drawn(rng, name):
    family, number = name.rsplit("_", 1)
    draw = {**FAMILIES, **parts.FAMILIES}[family]
    while True:
        try:
            return draw(rng, int(number))
        except Rejected:
            continue


def finished(name):
    """(STEP text, gap between edges in diameters): the set "shapes" turned, scaled and moved, parts as parts.py leaves
    them."""
    rng = random.Random(name)
    loops = drawn(rng, name)
    if name.rsplit("_", 1)[0] in parts.COUNTS:
        return parts.finished(rng, name, loops)
    turn = unit(rng.uniform(0, 2 * math.pi)) if rng.random() < 0.5 else 1
    size = 10 ** rng.uniform(-1, 2)
    shift = size * complex(rng.uniform(-3, 3), rng.uniform(-3, 3))
    return step_text(name, [moved(loop, size * turn, shift) for loop in loops]), 0.0


def write(name, folder):
    path = os.path.join(folder, name + ".step")
    with open(path, "w", encoding="ascii") as file:
        file.write(finished(name)[0])
    return path


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--set", choices=SETS, default="shapes")
    parser.add_argument("--sample", action="store_true", help="only the sample of 50")
    parser.add_argument("folder")
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    for name in options.names or (sample if options.sample else names)(options.set):
        write(name, options.folder)


if __name__ == "__main__":
    main()
