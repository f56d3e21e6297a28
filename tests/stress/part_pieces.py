"""Lengths, outlines with treated corners and checks, for the families of parts.py and machine_parts.py."""
import math

from loops import Rejected, check_clearance, corner_angles, inside, points_of, unit, whole
from step_text import polygon


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
