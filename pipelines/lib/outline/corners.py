"""Where smooth curves end: at corners of a loop, at the trailing edge of an aerofoil; its edges also end at the nose."""
import cmath
import math

from outline import polygons

ACROSS = 15.0  # degrees between a flat back and the vertical, at most


def turning_angle(before, after):
    """Between two directions, in degrees, 0 to 180."""
    return abs(math.degrees(cmath.phase(before.conjugate() * after)))


def mark_corners(loop, angle):
    """Marks the points where the polygon turns by more than `angle` degrees."""
    points = loop.points
    for i, z in enumerate(points):
        # An angle equal to the limit up to rounding is no corner, at all points of a symmetric loop alike.
        if turning_angle(z - points[i - 1], points[(i + 1) % len(points)] - z) > angle + 1e-6:
            loop.corners.add(i)


def mark_aerofoil(file, loop, nose, prefix):
    """Names the sides, marks the trailing edge (a corner, or two where it is blunt) and the nose, `nose` or, if None,
    the point farthest from the trailing edge. Returns the positions of nose and trailing edge."""
    count = len(loop.points)
    is_blunt = count - 1 in loop.corners
    tail = (loop.points[0] + loop.points[-1]) / 2 if is_blunt else loop.points[0]
    if nose is None:
        nose = max(range(count), key=lambda i: abs(loop.points[i] - tail))
    if not 0 < nose < count - is_blunt:
        raise file.fault(loop.lines[nose % count], "the nose is the first or the last point: one side has no points")
    name_sides(loop, nose, tail, prefix)
    if is_blunt:
        loop.names[-1] = prefix + "trailing_edge"
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
