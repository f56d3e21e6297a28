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

from loops import (Rejected, backwards, box, check_clearance, circle, corner_angles, disc, hole, inside, moved,
                   points_of, rounded_box, unit, whole)
from step_text import cubic_through, polygon, step_text
from worn_step import WEARS, worn_text

COUNTS = {"chamfer": 180, "frame": 100, "slot": 130, "fillet": 130, "pattern": 150, "rack": 60, "gear": 90,
          "connector": 100, "bracket": 60}


# ------------------------------------------------------------------------------------------------ pieces

def grid(rng, low, high, step=0.5):
    """A length between low and high on the grid."""
    return step * whole(rng, math.ceil(low / step), math.floor(high / step))


def treated(corners, treatments):
    """A loop with corners that are ("chamfer", leg before, leg after), ("fillet", radius) or None, sharp."""
    points, radii = [], []
    for i, (corner, treatment) in enumerate(zip(corners, treatments)):
        into, out = corners[i - 1] - corner, corners[(i + 1) % len(corners)] - corner
        if treatment and treatment[0] == "chamfer":
            points += [corner + treatment[1] * into / abs(into), corner + treatment[2] * out / abs(out)]
            radii += [0, 0]
        else:
            points.append(corner)
            radii.append(treatment[1] if treatment else 0)
    require_room(corners, treatments)
    return polygon(points, radii)


def require_room(corners, treatments):
    """Rejects corners whose chamfers or fillets would meet."""
    angles = corner_angles(corners)
    used = []
    for angle, treatment in zip(angles, treatments):
        if treatment and treatment[0] == "fillet":
            length = treatment[1] / abs(math.tan(math.radians(angle) / 2))
            used.append((length, length))
        else:
            used.append(tuple(treatment[1:]) if treatment else (0, 0))
    for i in range(len(corners)):
        length = abs(corners[i] - corners[i - 1])
        if used[i - 1][1] + used[i][0] > 0.98 * length:
            raise Rejected


def profile(rng, kind):
    """Corners of an outline on the grid: rectangle, angle, tee, channel, cross, step, trapezoid."""
    w, h = grid(rng, 10, 60), grid(rng, 10, 40)
    a, b = grid(rng, 0.15 * w, 0.4 * w), grid(rng, 0.2 * h, 0.7 * h)
    c = a if rng.random() < 0.5 else grid(rng, 0.15 * w, 0.4 * w)
    d = b if rng.random() < 0.5 else grid(rng, 0.2 * h, 0.7 * h)
    shapes = (
        [(0, 0), (w, 0), (w, h), (0, h)],
        [(0, 0), (w, 0), (w, h - b), (w - a, h - b), (w - a, h), (0, h)],
        [(0, 0), (w, 0), (w, h - b), (w - a, h - b), (w - a, h), (c, h), (c, h - d), (0, h - d)],
        [(0, 0), (w, 0), (w, h), (w - a, h), (w - a, h - b), (c, h - b), (c, h), (0, h)],
        [(a, 0), (w - a, 0), (w - a, b / 3), (w, b / 3), (w, h - b / 3), (w - a, h - b / 3), (w - a, h), (a, h),
         (a, h - b / 3), (0, h - b / 3), (0, b / 3), (a, b / 3)],
        [(0, 0), (w - a, 0), (w - a, b), (w, b), (w, h), (c, h), (c, h - min(d, h - b)), (0, h - min(d, h - b))],
        [(0, 0), (w, 0), (w - a, h), (c, h)])
    return [complex(*point) for point in shapes[kind % len(shapes)]], w, h


def leg(rng, least):
    """The leg of a chamfer or the radius of a fillet, as drawings have them, of all sizes up to half of the side."""
    usual = [x for x in (0.1, 0.2, 0.3, 0.5, 0.8, 1, 1.5, 2, 2.5, 3, 4, 5, 8, 10) if x < 0.48 * least]
    return rng.choice(usual) if usual and rng.random() < 0.8 else least * 10 ** rng.uniform(-2.3, -0.35)


def chamfers(rng, corners, share):
    """One treatment for each corner: all the same size, or each its own; legs at 45 degrees or not."""
    sides = [abs(b - a) for a, b in zip(corners, corners[1:] + corners[:1])]
    same, tilt = rng.random() < 0.5, rng.choice((1, 1, 1, math.tan(math.radians(30)), 0.5, 2))
    common = leg(rng, min(sides))
    result = []
    for i in range(len(corners)):
        size = common if same else leg(rng, min(sides[i - 1], sides[i]))
        tilted = tilt if same or rng.random() < 0.5 else 1
        result.append(("chamfer", size, size * tilted) if rng.random() < share else None)
    return result


def placed(rng, outline, gap, make, tries=300):
    """A hole that keeps the gap from the outline; `make` takes its centre."""
    points = [p for edge in outline[0] for p in points_of(edge, gap)]
    low = complex(min(p.real for p in points), min(p.imag for p in points))
    high = complex(max(p.real for p in points), max(p.imag for p in points))
    for _ in range(tries):
        centre = complex(grid(rng, low.real, high.real), grid(rng, low.imag, high.imag))
        loops = outline + [make(centre)]
        try:
            check_inside(loops)
            check_clearance(loops, gap)
        except Rejected:
            continue
        return loops
    raise Rejected


def check_inside(loops):
    """Rejects holes that reach beyond the outline, or lie in others."""
    corners = [p for edge in loops[0] for p in points_of(edge, 1e9)]
    spacing = max(abs(p - corners[0]) for p in corners) / 60
    outer = [p for edge in loops[0] for p in points_of(edge, spacing)]
    for loop in loops[1:]:
        if not all(inside(p, outer) for edge in loop for p in points_of(edge, 4 * spacing)):
            raise Rejected
        points = [p for edge in loop for p in points_of(edge, spacing)]
        if any(inside(points_of(other[0], 1e9)[0], points) for other in loops[1:] if other is not loop):
            raise Rejected


def regular(centre, radius, sides, turn=0.0):
    return [centre + radius * unit(turn + 2 * math.pi * k / sides) for k in range(sides)]


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


def rack(rng, number):
    count, pitch = whole(rng, 3, 14), rng.choice((2, 3, math.pi, 5))
    flank = math.radians(rng.choice((14.5, 20, 25, 30)))
    depth, bar = pitch * rng.uniform(0.4, 0.75), grid(rng, 2, 12)
    lean = depth * math.tan(flank)
    tip = pitch / 2 - lean
    if tip < 0.05 * pitch:
        raise Rejected
    if number % 5 == 4:  # saw teeth, pointed
        tip, lean = 0, pitch / 2
    corners, radii = [complex(0, -bar), complex(count * pitch, -bar), complex(count * pitch, 0)], [0, 0, 0]
    top, foot = (rng.choice((0, 0.05, 0.1)) * pitch, rng.choice((0, 0.05, 0.1)) * pitch) if tip else (0, 0)
    for k in reversed(range(count)):
        x = (k + 0.5) * pitch
        high = [complex(x, depth)] if tip == 0 else [complex(x + tip / 2, depth), complex(x - tip / 2, depth)]
        foot_gap = [complex(x + tip / 2 + lean, 0), complex(x - tip / 2 - lean, 0)]
        if tip == 0 and k < count - 1:  # neighbours share their foot
            foot_gap = foot_gap[1:]
        elif tip == 0:
            corners, radii = corners[:-1], radii[:-1]
        low = foot_gap[:1] if len(foot_gap) > 1 else []
        corners += low + high + foot_gap[-1:]
        radii += [foot] * len(low) + [top] * len(high) + [foot]
    if tip == 0:
        loops = [polygon(corners, radii)]
    else:
        loops = [polygon(corners + [0j], radii + [0])]
    check_clearance(loops, 0.02 * pitch)
    return loops


def involute(base, angle):
    return base * unit(angle) * complex(1, -angle)


def flank_spline(base, low, high, turn, mirrored):
    """The involute between two radii as a cubic, from the foot to the tip; mirrored: in the x axis before the turn."""
    start, end = (math.sqrt(max((r / base) ** 2 - 1, 0)) for r in (low, high))
    count = 8
    parameters = [start + (end - start) * k / count for k in range(count + 1)]
    points = [involute(base, t) for t in parameters]
    slopes = [base * t * unit(t) for t in (start, end)]
    if mirrored:
        points, slopes = [p.conjugate() for p in points], [s.conjugate() for s in slopes]
    poles, knots = cubic_through([unit(turn) * p for p in points], parameters, unit(turn) * slopes[0],
                                 unit(turn) * slopes[1])
    return ("spline", poles, knots)


def involute_gear(rng, teeth, module):
    """Flanks from the base circle to the tip, roots and tips on circles; the outline."""
    pitch_radius = module * teeth / 2
    base, tip = pitch_radius * math.cos(math.radians(20)), pitch_radius + module
    root = pitch_radius - 1.25 * module
    thick = math.pi / (2 * teeth) + math.tan(math.radians(20)) - math.radians(20)  # half the tooth at the base circle
    loop = []
    for k in range(teeth):
        middle = 2 * math.pi * k / teeth
        rising = flank_spline(base, base, tip, middle - thick, False)
        falling = backwards([flank_spline(base, base, tip, middle + thick, True)])[0]
        following = 2 * math.pi * (k + 1) / teeth - thick
        feet = [root * unit(middle - thick), root * unit(middle + thick), root * unit(following)]
        loop += [("line", feet[0], rising[1][0]), rising, ("arc", 0j, tip, rising[1][-1], falling[1][0], 1), falling,
                 ("line", falling[1][-1], feet[1]), ("arc", 0j, root, feet[1], feet[2], 1)]
    return loop


def straight_gear(rng, teeth, tip, root, slant):
    """Straight flanks between two circles; slant 0: symmetric teeth, else ratchets. Corners, counter-clockwise."""
    corners = []
    for k in range(teeth):
        share = 2 * math.pi / teeth
        for radius, part in ((root, 0.0), (tip, 0.22 + slant), (tip, 0.48), (root, 0.7)):
            corners.append(radius * unit(share * (k + part)))
    return corners


def gear(rng, number):
    teeth, module = whole(rng, 8, 24), rng.choice((1, 1.5, 2))
    tip = module * (teeth / 2 + 1)
    root = tip - 2.25 * module
    kind = number % 5
    if kind == 0:
        if teeth < 12:
            raise Rejected
        loops = [involute_gear(rng, teeth, module)]
    elif kind in (1, 2):
        corners = straight_gear(rng, teeth, tip, root, 0 if kind == 1 else 0.24)
        loops = [polygon(corners, [rng.choice((0, 0.1)) * module] * len(corners))]
    elif kind == 3:  # inside a ring
        corners = straight_gear(rng, teeth, tip, root, 0)
        loops = [disc(tip + grid(rng, 2 * module, 5 * module)), hole(corners)]
        check_clearance(loops, 0.05 * module)
        return loops
    else:  # a sprocket: round pockets between teeth that end flat
        loops = [sprocket(rng, teeth, tip, 2 * math.pi * tip / teeth * 0.28)]
    bore = grid(rng, 0.2 * root, 0.45 * root)
    if number % 3 == 0:
        width = grid(rng, 0.3 * bore, 0.7 * bore, 0.1)
        loops.append(keyway(bore, width, 1.25 * bore))
    else:
        loops.append(circle(0j, bore))
    if number % 4 == 1 and root - bore > 6 * module:
        count, middle = whole(rng, 3, 8), (root + bore) / 2
        radius = min(0.3 * (root - bore), 0.7 * middle * math.sin(math.pi / count))
        loops += [circle(middle * unit(2 * math.pi * k / count), radius) for k in range(count)]
    check_clearance(loops, 0.05 * module)
    return loops


def sprocket(rng, teeth, tip, pocket):
    """Pockets of a radius whose centres lie on the tip circle; the outline."""
    half = 2 * math.asin(pocket / (2 * tip))
    loop = []
    for k in range(teeth):
        here, there = 2 * math.pi * k / teeth, 2 * math.pi * (k + 1) / teeth
        a, b, c = tip * unit(here + half), tip * unit(there - half), tip * unit(there + half)
        loop += [("arc", 0j, tip, a, b, 1), ("arc", tip * unit(there), pocket, b, c, -1)]
    return loop


def keyway(bore, width, depth):
    """A bore with a rectangular keyway; a hole."""
    reach = math.sqrt(bore**2 - width**2 / 4)
    a, b = complex(reach, -width / 2), complex(depth, -width / 2)
    c, d = b.conjugate(), a.conjugate()
    return backwards([("line", a, b), ("line", b, c), ("line", c, d), ("arc", 0j, bore, d, a, 1)])


def pin_row(rng, pitch, count, leg_length):
    """The outline of a pin header: a rectangle for each pin with chamfered corners, one beside the other."""
    upper, lower = [], []
    for k in range(count):
        x = k * pitch
        lower += [complex(x, leg_length), complex(x + leg_length, 0), complex(x + pitch - leg_length, 0)]
        upper += [complex(x + leg_length, pitch), complex(x + pitch - leg_length, pitch)]
        if k < count - 1:
            upper.append(complex(x + pitch, pitch - leg_length))
    right = [complex(count * pitch, leg_length), complex(count * pitch, pitch - leg_length)]
    return lower + right + upper[::-1] + [complex(0, pitch - leg_length)]


def connector(rng, number):
    pitch = rng.choice((2.54, 1.27, 2, 2.5))
    count, kind = whole(rng, 1, 10), number % 5
    pins = [complex((k + 0.5) * pitch, pitch / 2) for k in range(count)]
    half = rng.choice((0.32, 0.3, 0.25)) * pitch / 2.54 * 2
    if kind == 0:
        loops = [polygon(pin_row(rng, pitch, count, rng.choice((0.1, 0.15, 0.25)) * pitch))]
        loops += [hole(box(pin, half, half, 0)) for pin in pins]
    elif kind == 1:  # a housing with a key, rows of square holes
        rows, wall = whole(rng, 1, 3), rng.choice((0.5, 1, 1.27))
        w, h = count * pitch + 2 * wall, rows * pitch + 2 * wall
        key = min(grid(rng, 1, 4), 0.5 * w)
        deep = 0.5 * wall
        corners = [0j, complex(w / 2 - key / 2, 0), complex(w / 2 - key / 2, deep), complex(w / 2 + key / 2, deep),
                   complex(w / 2 + key / 2, 0), complex(w, 0), complex(w, h), complex(0, h)]
        size = rng.choice((0, 0.2, 0.5)) * wall
        ends = {0: ("chamfer", size, size), 5: ("chamfer", size, size)} if size else {}
        loops = [treated(corners, [ends.get(i) for i in range(len(corners))])]
        loops += [hole(box(complex(wall, wall) + pin + 1j * j * pitch, half, half, 0)) for pin in pins
                  for j in range(rows)]
    elif kind == 2:  # the shell of a D-sub or HDMI: a rounded trapezoid with screw holes
        w, h = grid(rng, 12, 40), grid(rng, 6, 12)
        lean = h * math.tan(math.radians(10))
        shell = [complex(-w / 2 + lean, -h / 2), complex(w / 2 - lean, -h / 2), complex(w / 2, h / 2),
                 complex(-w / 2, h / 2)]
        flange = box(0j, w + 20, h + 5, 0)
        loops = [treated(flange, [("fillet", rng.choice((0.5, 1, 2)))] * 4),
                 backwards(treated(shell, [("fillet", rng.choice((0.5, 1, 1.5)))] * 4))]
        loops += [circle(side * (w / 2 + 5) + 0j, 1.5) for side in (-1, 1)]
    elif kind == 3:  # an edge connector: fingers with chamfers or round ends on a bar
        width, length = 0.6 * pitch, grid(rng, 2, 6)
        size = rng.choice((0.1, 0.2, 0.5 * 0.6)) * pitch
        corners, treatments = [0j, complex(count * pitch, 0), complex(count * pitch, 3)], [None] * 3
        for k in reversed(range(count)):
            x = (k + 0.5) * pitch
            corners += [complex(x + width / 2, 3), complex(x + width / 2, 3 + length),
                        complex(x - width / 2, 3 + length), complex(x - width / 2, 3)]
            end = ("fillet", 0.9 * size) if number % 2 else ("chamfer", 0.9 * size, 0.9 * size)
            treatments += [None, end, end, None]
        loops = [treated(corners + [3j], treatments + [None])]
    else:  # USB: a rounded shell around a tongue, unequal chamfers below
        w, h = grid(rng, 7, 15), grid(rng, 3, 6)
        size = grid(rng, 0.3, 0.3 * h, 0.1)
        corners = box(0j, w, h, 0)
        outline = treated(corners, [("chamfer", size, 1.5 * size)] * 2 + [("fillet", 0.3)] * 2)
        tongue = box(0.1j * h, 0.6 * w, 0.25 * h, 0)
        loops = [outline, hole(tongue)]
    check_inside(loops)
    check_clearance(loops, 0.02 * pitch)
    return loops


def bracket(rng, number):
    w = grid(rng, 20, 60)
    kind = number % 4
    if kind == 0:  # a motor flange
        size = grid(rng, 0.05 * w, 0.2 * w)
        corners, reach = box(0j, w, w, 0), 0.37 * w
        end = rng.choice((("chamfer", size, size), ("fillet", size)))
        loops = [treated(corners, [end] * 4), circle(0j, grid(rng, 0.15 * w, 0.3 * w))]
        loops += [circle(complex(x * reach, y * reach), 0.05 * w) for x in (-1, 1) for y in (-1, 1)]
    elif kind == 1:  # a lug: half round, tapered, with an eye
        r = grid(rng, 0.12 * w, 0.2 * w)
        foot, height = 0.35 * w, 0.6 * w
        distance = abs(complex(foot, height))
        angle = cmath.phase(complex(foot, -height)) + math.acos(r / distance)
        touch = r * unit(angle)
        centre = complex(0, height)
        right, left = centre + touch, centre + complex(-touch.real, touch.imag)
        loops = [[("line", complex(-foot, 0), complex(foot, 0)), ("line", complex(foot, 0), right),
                  ("arc", centre, r, right, left, 1), ("line", left, complex(-foot, 0))],
                 circle(centre, 0.5 * r)]
    elif kind == 2:  # an angle with holes in both arms, one inner fillet, chamfered ends
        a, thick, size = grid(rng, 0.6 * w, w), grid(rng, 0.2 * w, 0.3 * w), grid(rng, 0.02 * w, 0.08 * w, 0.1)
        corners = [0j, complex(w, 0), complex(w, thick), complex(thick, thick), complex(thick, a), complex(0, a)]
        end = ("chamfer", size, size)
        loops = [treated(corners, [None, end, end, ("fillet", size), end, end]),
                 circle(complex(0.7 * w, thick / 2), 0.25 * thick), circle(complex(thick / 2, 0.7 * a), 0.25 * thick)]
    else:  # a flange of two lobes
        r, reach = grid(rng, 0.2 * w, 0.3 * w), 0.5 * w
        small = 0.4 * r
        angle = math.acos((r - small) / reach)
        a, b = r * unit(angle), reach + small * unit(angle)
        loops = [[("arc", 0j, r, a, -a.conjugate(), 1), ("line", -a.conjugate(), -b.conjugate()),
                  ("arc", complex(-reach), small, -b.conjugate(), -b, 1), ("line", -b, -a),
                  ("arc", 0j, r, -a, a.conjugate(), 1), ("line", a.conjugate(), b.conjugate()),
                  ("arc", complex(reach), small, b.conjugate(), b, 1), ("line", b, a)],
                 circle(0j, 0.6 * r), circle(complex(reach), 0.5 * small), circle(complex(-reach), 0.5 * small)]
    check_inside(loops)
    check_clearance(loops, 0.015 * w)
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
