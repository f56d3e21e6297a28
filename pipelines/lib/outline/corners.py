"""Where smooth curves end: at corners of a loop, at the trailing edge of an aerofoil; its edges also end at the nose."""
import cmath
import math

from outline import polygons

ACROSS = 15.0  # degrees between a flat back and the vertical, at most
SHARP = 30.0  # degrees: a turn above this is a corner of a loop of points
# An arc through points that are rounded turns by up to this factor more than SHARP at some of them, as its neighbours do.
ARC_MARGIN, LIKE = 1.1, 0.85
# A turn is a corner too if it is so many times the one that the turns beside it lead to expect, and above so many degrees.
TIMES, LEAST_TURN = 4.0, 5.0
MOST_GROWTH = 4.0  # of turns from point to point towards a round nose: those of a parabola whose nose has few points


def turning_angle(before, after):
    """Between two directions, in degrees, 0 to 180."""
    return abs(math.degrees(cmath.phase(before.conjugate() * after)))


def turns(points):
    """Of a closed polygon at its points, in degrees, -180 to 180; positive to the left."""
    steps = [b - a for a, b in zip(points, points[1:] + points[:1])]
    return [math.degrees(cmath.phase(before.conjugate() * after)) for before, after in zip(steps[-1:] + steps[:-1], steps)]


def turn_errors(points, rounding):
    """The greatest errors of these turns, in degrees, if coordinates have these rounding errors."""
    steps = [abs(b - a) for a, b in zip(points, points[1:] + points[:1])]
    return [math.degrees(2 * rounding * (1 / before + 1 / after)) for before, after in zip(steps[-1:] + steps[:-1], steps)]


def stands_out(angles, errors, i):
    """Whether the turn at a point is far from those beside it: a smooth curve turns there about as it does at the next
    points, or grows towards a nose as fast as from the second point beside it to the first. `errors`: of the turns."""
    count = len(angles)
    size = lambda k: max(abs(angles[k % count]) - errors[k % count], 0.0)
    expected = 0.0
    for step in (1, -1):
        first, second = size(i + step), size(i + 2 * step)
        growth = min(first / second, MOST_GROWTH) if second > 0 else MOST_GROWTH
        expected = max(expected, first * max(growth, 1.0))
    return abs(angles[i]) > max(TIMES * expected, LEAST_TURN + errors[i])


def is_of_coarse_arc(angles, i):
    """Whether a turn is hardly above SHARP, and both neighbours turn alike."""
    beside = angles[i - 1], angles[(i + 1) % len(angles)]
    return abs(angles[i]) <= ARC_MARGIN * SHARP and all(LIKE <= turn / angles[i] <= 1 / LIKE for turn in beside)


def mark_corners(loop, angle):
    """Marks the points where the polygon turns by more than `angle` degrees."""
    # An angle equal to the limit up to rounding is no corner, at all points of a symmetric loop alike.
    loop.corners.update(i for i, turn in enumerate(turns(loop.points)) if abs(turn) > angle + 1e-6)


def mark_sharp_corners(loop, rounding, is_aerofoil=False):
    """Marks the points whose turn stands out, and those that turn by more than SHARP degrees, but not of an aerofoil with
    few points around its nose. `rounding`: the greatest error of a coordinate."""
    angles, errors = turns(loop.points), turn_errors(loop.points, rounding)
    for i, turn in enumerate(angles):
        is_sharp = not is_aerofoil and abs(turn) > SHARP + 1e-6 and not is_of_coarse_arc(angles, i)
        if is_sharp or stands_out(angles, errors, i):
            loop.corners.add(i)


def mark_aerofoil(file, loop, base, nose, prefix):
    """Of a loop that begins at the trailing edge, which is sharp or, if it is blunt, ends it from the point `base` on:
    names the sides, marks the trailing edge (a corner, or two) and the nose, `nose` or, if None, the point farthest from
    the trailing edge. Returns the positions of nose and trailing edge."""
    count = len(loop.points)
    tail = loop.points[0] if base is None else (loop.points[0] + loop.points[base]) / 2
    last = count if base is None else base
    if nose is None:
        nose = max(range(count), key=lambda i: abs(loop.points[i] - tail))
    if not 0 < nose < last:
        raise file.fault(loop.lines[nose % count], "the nose is the first or the last point: one side has no points")
    name_sides(loop, nose, tail, prefix)
    if base is not None:
        loop.names[base:] = [prefix + "trailing_edge"] * (count - base)
        loop.corners.add(base)
    loop.corners.add(0)
    loop.joints.add(nose)
    return loop.points[nose], tail


def name_sides(loop, nose, tail, prefix):
    """The side whose points lie higher above the chord on average is the upper one."""
    front = loop.points[nose]
    height = lambda side: sum(((tail - front).conjugate() * (z - front)).imag for z in side) / len(side)
    sides = ["upper", "lower"]
    if height(loop.points[: nose + 1]) < height(loop.points[nose:]):
        sides.reverse()
    loop.names[:] = [prefix + sides[i >= nose] for i in range(len(loop.points))]


def back_middle(loop, i, tolerance):
    """The middle of the straight edge about across the direction of x that ends at the corner i, the rightmost point of
    the loop; else None. Of two such edges, the one that is more so; None if both are alike."""
    runs = [straight_run(loop, i, step, tolerance) for step in (1, -1)]
    backs = sorted(((tilt(run), sum(run) / 2) for run in runs if run is not None and tilt(run) <= ACROSS),
                   key=lambda back: back[0])
    return backs[0][1] if len(backs) == 1 or len(backs) == 2 and backs[1][0] - backs[0][0] > 1e-6 else None


def straight_run(loop, i, step, tolerance):
    """Both ends of the edge from the corner i to the next one in the direction of step, or None if it is not straight."""
    count = len(loop.points)
    k = next(k for k in range(1, count + 1) if (i + k * step) % count in loop.corners)
    points = [loop.points[(i + m * step) % count] for m in range(k + 1)]
    if k == count or any(polygons.distance_to_segment(z, points[0], points[-1]) > tolerance for z in points[1:-1]):
        return None
    return points[0], points[-1]


def tilt(run):
    """Of a segment against the vertical, in degrees, 0 to 90."""
    return 90 - abs(turning_angle(run[1] - run[0], 1j) - 90)
