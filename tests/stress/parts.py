"""1,000 faces as they come from CAD programs, from fixed seeds: a second set of families for families.py.

  chamfer  180  plates, angles, tees and steps with chamfers of all sizes, at 45 degrees or not, equal or not
  frame    100  chamfers, equal or not, around square, chamfered and round holes
  slot     130  plates with slots: straight at any angle, curved, keyholes, open ones with round ends
  fillet   130  the outlines of chamfer with fillets from a thousandth of the size up, inside and outside
  pattern  150  holes on square and triangular grids and on bolt circles, round, square and hexagonal, of two sizes
  rack      60  racks and combs: straight flanks of 14.5 to 30 degrees, pointed, flat, filleted
  gear      90  gear wheels outside and inside, sprockets and ratchets, with bores, keyways and holes
  connector 100 connectors on a grid of 2.54 or 1.27: housings of octagons, pads, shells with keys, pin rows
  bracket   60  brackets and flanges: lugs, bores, round and square, symmetric or nearly

All lengths stand on a grid of millimetres or its parts, as drawings have them: lines are often collinear or equal.
Every second shape is as exact as its digits; the others have edges that do not quite meet, by 1e-7 to 1e-4 of the size
(worn_step.py). Shapes are turned by multiples of 15 degrees or any angle, mirrored, and moved far away.
"""
import cmath
import math

from loops import (Rejected, backwards, box, check_clearance, circle, disc, hole, moved, points_of, rounded_box, unit,
                   whole)
from part_pieces import chamfers, check_inside, grid, leg, placed, profile, regular, treated
from machine_parts import bracket, connector, gear, rack
from step_text import polygon, step_text
from worn_step import WEARS, worn_text

COUNTS = {"chamfer": 180, "frame": 100, "slot": 130, "fillet": 130, "pattern": 150, "rack": 60, "gear": 90,
          "connector": 100, "bracket": 60}


# ------------------------------------------------------------------------------------------------ families

def chamfer(rng, number):
    corners, w, h = profile(rng, number)
    outline = [treated(corners, chamfers(rng, corners, rng.choice((1, 1, 0.7, 0.3))))]
    size = min(w, h)
    if number % 3 == 0:
        return outline
    radius = grid(rng, 0.06 * size, 0.15 * size, 0.1)
    if number % 3 == 1:
        return placed(rng, outline, 0.05 * size, lambda c: circle(c, radius))
    return placed(rng, outline, 0.05 * size, lambda c: hole(box(c, 2 * radius, 2 * radius, 0)))


def frame(rng, number):
    w = grid(rng, 12, 40)
    h = w if number % 2 else grid(rng, 12, 40)
    outer = box(0j, w, h, 0)
    outline = treated(outer, chamfers(rng, outer, rng.choice((1, 0.75, 0.5))))
    a = grid(rng, 0.3 * w, 0.6 * w)
    b = a if number % 2 else grid(rng, 0.3 * h, 0.6 * h)
    centre = 0j if rng.random() < 0.5 else complex(grid(rng, -0.12 * w, 0.12 * w), grid(rng, -0.12 * h, 0.12 * h))
    inner = box(centre, a, b, 0)
    if number % 4 == 3:
        window = circle(centre, min(a, b) / 2)
    elif number % 4 == 1:
        window = backwards(treated(inner, chamfers(rng, inner, 1)))
    else:
        window = hole(inner)
    loops = [outline, window]
    check_inside(loops)
    check_clearance(loops, 0.04 * min(w, h))
    return loops


def curved_slot(centre, radius, width, start, angle):
    """Between two arcs about the centre, with round ends; a hole."""
    inner, outer = radius - width / 2, radius + width / 2
    a, b = unit(start), unit(start + angle)
    return backwards([("arc", centre, outer, centre + outer * a, centre + outer * b, 1),
                      ("arc", centre + radius * b, width / 2, centre + outer * b, centre + inner * b, 1),
                      ("arc", centre, inner, centre + inner * b, centre + inner * a, -1),
                      ("arc", centre + radius * a, width / 2, centre + inner * a, centre + outer * a, 1)])


def keyhole(centre, radius, width, length, turn):
    """A round hole with a slot; a hole."""
    reach = math.sqrt(radius**2 - width**2 / 4)
    a, b = (centre + unit(turn) * complex(reach, y * width / 2) for y in (-1, 1))
    c, d = (centre + unit(turn) * complex(length, y * width / 2) for y in (-1, 1))
    return backwards([("line", a, c), ("arc", centre + unit(turn) * length, width / 2, c, d, 1), ("line", d, b),
                      ("arc", centre, radius, b, a, 1)])


def open_slots(rng, w, h):
    """A plate with slots from its upper side, their ends round or filleted."""
    count, width, depth = whole(rng, 1, 5), grid(rng, 1, 4), grid(rng, 0.2 * h, 0.7 * h)
    pitch = w / (count + 0.5)
    if width > 0.6 * pitch:
        raise Rejected
    corners, radii = [0j, complex(w, 0), complex(w, h)], [0, 0, 0]
    end = 0.5 * width if rng.random() < 0.5 else grid(rng, 0.1 * width, 0.4 * width, 0.1)
    mouth = rng.choice((0, 0, 0.3))
    for k in reversed(range(count)):
        x = w / 2 + (k - (count - 1) / 2) * pitch
        corners += [complex(x + width / 2, h), complex(x + width / 2, h - depth), complex(x - width / 2, h - depth),
                    complex(x - width / 2, h)]
        radii += [mouth, end, end, mouth]
    loop = polygon(corners + [complex(0, h)], radii + [0])
    return [[edge for edge in loop if edge[0] != "line" or abs(edge[1] - edge[2]) > 1e-9]]


def slot(rng, number):
    w, h = grid(rng, 20, 60), grid(rng, 12, 40)
    size = min(w, h)
    if number % 5 == 4:
        return open_slots(rng, w, h)
    corners = box(0j, w, h, 0)
    loops = [treated(corners, [("fillet", leg(rng, size))] * 4 if rng.random() < 0.5 else [None] * 4)]
    for _ in range(whole(rng, 1, 3)):
        width = grid(rng, 0.05 * size, 0.2 * size, 0.1)
        length = width + grid(rng, 0.1 * size, 0.5 * size)
        turn = math.radians(rng.choice((0, 90, 0, 90, 45, 30, rng.uniform(0, 180))))
        if number % 5 < 2:
            def make(c, length=length, width=width, turn=turn):
                return backwards(rounded_box(c, length, width, turn))
        elif number % 5 == 2:
            angle = math.radians(rng.choice((30, 45, 60, 90, 120)))
            def make(c, length=length, width=width, turn=turn, angle=angle):
                return curved_slot(c, max(length / 2, 0.8 * width), width, turn, angle)
        else:
            def make(c, length=length, width=width, turn=turn):
                return keyhole(c, width, width, width + length / 2, turn)
        loops = placed(rng, loops, 0.04 * size, make)
    return loops


def fillet(rng, number):
    corners, w, h = profile(rng, number)
    sides = [abs(b - a) for a, b in zip(corners, corners[1:] + corners[:1])]
    same, common = rng.random() < 0.5, leg(rng, min(sides))
    share = rng.choice((1, 1, 0.6))
    treatments = []
    for i in range(len(corners)):
        size = common if same else leg(rng, min(sides[i - 1], sides[i]))
        kind = ("chamfer", size, size) if number % 5 == 4 and rng.random() < 0.4 else ("fillet", size)
        treatments.append(kind if rng.random() < share else None)
    outline, size = [treated(corners, treatments)], min(w, h)
    if number % 3 == 0:
        return outline
    radius = grid(rng, 0.06 * size, 0.15 * size, 0.1)
    return placed(rng, outline, 0.05 * size, lambda c: circle(c, radius))


def lattice(rng, kind, pitch, columns, rows):
    """Centres about the origin: a square grid, a triangular one, or every second of a square one."""
    points = []
    for j in range(rows):
        for i in range(columns):
            if kind == 2 and (i + j) % 2:
                continue
            step = 0.5 if kind == 1 and j % 2 else 0
            height = math.sqrt(0.75) if kind == 1 else 1
            points.append(pitch * complex(i + step - (columns - 1) / 2 - (0.25 if kind == 1 else 0),
                                          height * (j - (rows - 1) / 2)))
    return points


def cut(rng, radius, sides, turn):
    """A function from a centre to a hole: round, square or hexagonal."""
    return lambda c: circle(c, radius) if sides == 0 else hole(regular(c, radius, sides, turn))


def pattern(rng, number):
    sides = (0, 0, 0, 0, 4, 6)[number % 6]
    if number % 3 == 2:
        return bolt_circles(rng, number, sides)
    pitch = rng.choice((2.54, 5, 8, 10))
    columns, rows = whole(rng, 2, 7), whole(rng, 2, 5)
    centres = lattice(rng, whole(rng, 0, 2), pitch, columns, rows)
    radius = grid(rng, 0.12 * pitch, 0.36 * pitch, 0.1 if pitch > 3 else 0.01)
    margin = grid(rng, 0.7 * pitch, 1.2 * pitch)
    w = 2 * (max(c.real for c in centres) + margin)
    h = 2 * (max(abs(c.imag) for c in centres) + margin)
    corners = box(0j, w, h, 0)
    treatment = rng.choice((None, ("fillet", leg(rng, margin)), ("chamfer", *[leg(rng, margin)] * 2)))
    if treatment and treatment[0] == "chamfer":
        treatment = ("chamfer", treatment[1], treatment[1])
    turn = math.pi / 4 if sides == 4 else 0.0
    small = rng.choice((1, 1, 0.5))
    holes = [cut(rng, radius * (small if k % 2 else 1), sides, turn)(c) for k, c in enumerate(centres)]
    loops = [treated(corners, [treatment] * 4)] + holes
    check_inside(loops)
    check_clearance(loops, 0.1 * pitch)
    return loops


def bolt_circles(rng, number, sides):
    size = grid(rng, 10, 40)
    if number % 2:
        loops = [disc(size)]
    else:
        corners = box(0j, 2.1 * size, 2.1 * size, 0)
        loops = [treated(corners, [("fillet", leg(rng, size))] * 4)]
    if rng.random() < 0.8:
        loops.append(circle(0j, grid(rng, 0.15 * size, 0.4 * size)))
    count = whole(rng, 3, 12)
    reach, radius = grid(rng, 0.6 * size, 0.75 * size), grid(rng, 0.04 * size, 0.12 * size, 0.1)
    turn = rng.choice((0.0, math.pi / count, rng.uniform(0, 1)))
    for k in range(count):
        at = unit(turn + 2 * math.pi * k / count)
        loops.append(cut(rng, radius, sides, cmath.phase(at))(reach * at))
    check_inside(loops)
    check_clearance(loops, 0.04 * size)
    return loops


FAMILIES = {"chamfer": chamfer, "frame": frame, "slot": slot, "fillet": fillet, "pattern": pattern, "rack": rack,
            "gear": gear, "connector": connector, "bracket": bracket}


# ------------------------------------------------------------------------------------------------ shapes

def mirrored(loop):
    """In the y axis; the loop still runs the same way round."""
    flipped = []
    for kind, *rest in backwards(loop):
        if kind == "line":
            flipped.append(("line", -rest[0].conjugate(), -rest[1].conjugate()))
        elif kind == "arc":
            centre, radius, a, b, side = rest
            flipped.append(("arc", -centre.conjugate(), radius, -a.conjugate(), -b.conjugate(), -side))
        elif kind == "circle":
            flipped.append(("circle", -rest[0].conjugate(), rest[1], -rest[2]))
        else:
            flipped.append(("spline", [-p.conjugate() for p in rest[0]], rest[1]))
    return flipped


def shortest_edge(loops):
    """By the distance of the ends, or the radius."""
    lengths = {"line": lambda a, b: abs(b - a), "arc": lambda centre, radius, a, b, side: min(radius, abs(b - a)),
               "circle": lambda centre, radius, side: radius, "spline": lambda poles, knots: abs(poles[-1] - poles[0])}
    return min(lengths[kind](*rest) for loop in loops for kind, *rest in loop)


def finished(rng, name, loops):
    """(STEP text, gap in diameters) of the part as a CAD program would have left it: turned, mirrored, moved, with
    edges that do not quite meet."""
    number = int(name.rsplit("_", 1)[1])
    if rng.random() < 0.3:
        loops = [mirrored(loop) for loop in loops]
    turn = unit(math.radians(rng.choice((0, 0, 0, 90, 45, 30, 15, rng.uniform(0, 360)))))
    size = 10 ** rng.choice((0, 0, 0, -3, 1))  # millimetres, metres, tenths
    points = [p for p in (q for edge in loops[0] for q in points_of(edge, 1e9))]
    diameter = 2 * size * max(abs(p - points[0]) for p in points[1:] or [points[0] + 1])
    shift = diameter * rng.choice((0, 0, 1, 10, 100)) * complex(rng.uniform(-1, 1), rng.uniform(-1, 1))
    loops = [moved(loop, size * turn, shift) for loop in loops]
    if number % 2 == 0:
        return step_text(name, loops), 0.0
    # A gap of the size of an edge is no gap.
    gap = min(diameter * 10 ** rng.uniform(-7, -4), 0.02 * shortest_edge(loops))
    return worn_text(name, loops, rng, WEARS[number // 2 % len(WEARS)], gap), gap / diameter
