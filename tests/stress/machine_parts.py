"""Racks, gears, connectors and brackets: families of parts.py."""
import cmath
import math

from loops import Rejected, backwards, box, check_clearance, circle, disc, hole, rounded_polygon, unit, whole
from part_pieces import check_inside, grid, treated
from step_text import cubic_through, polygon


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
        loops = [rounded_polygon(corners, radii)]
    else:
        loops = [rounded_polygon(corners + [0j], radii + [0])]
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
        loops = [rounded_polygon(corners, [rng.choice((0, 0.1)) * module] * len(corners))]
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
