"""Recognises an aerofoil by its points: from the trailing edge around the nose and back, as in Selig's files; in two
halves from the nose, as in Lednicer's; or from the nose around the trailing edge."""
from dataclasses import dataclass

from outline import corners, polygons
from outline.box_tree import BoxTree
from outline.loops import Loop

SAME = 1e-9  # points nearer to each other are one; in diagonals of the box around them
LEAST_POINTS = 10  # of an aerofoil
SIDE_SEGMENTS = 4  # of each side, at least
THICKEST = 0.6  # in chords
LONGEST_BASE = 0.2  # of a blunt trailing edge, in diagonals of the box around the points
BASE_OF_THICKNESS = 0.6  # in thicknesses: what is higher is the flat back of a bluff body
BASE_CORNER, TAIL_TURN = 30.0, 100.0  # degrees: turns at a corner of the base, and at the whole trailing edge
SIDE_CORNER, NOSE_CORNER = 45.0, 60.0  # degrees: sides have no such corner, and a nose no two of them
NOSE_PART = 0.05  # chords behind the nose, where points turn by more
BACKWARDS = 0.02  # chords that a side may run back: around a nose whose first point is not the farthest
START_PART = 0.05  # of that diagonal: the first point is so near to the nose or to the trailing edge
CROSSING_PART = 0.05  # of that diagonal: from the trailing edge to where its sides may cross by rounding
CROSSING = 10  # rounding errors by which they may
LEAST_CROSSING = 5e-4  # of that diagonal, by which they may too


@dataclass
class Aerofoil:
    loop: Loop  # begins at the trailing edge
    base: int  # the point from which on it is the base of a blunt trailing edge; None if it is sharp
    nose: int


def recognise(loop, rounding=0.0):
    """The loop as an aerofoil, which begins at its trailing edge, or None. The loop has no repeated points; `rounding`: the
    greatest error of a coordinate."""
    points = loop.points
    if len(points) < LEAST_POINTS:
        return None
    turns = corners.turns(points), corners.turn_errors(points, rounding)
    far = max(range(len(points)), key=lambda i: abs(points[i] - points[0]))
    found = [shape for shape in (shape_with_tail(points, turns, i) for i in (0, far)) if shape]
    if not found:
        return None
    # Both ends may be sharp: the air comes from the left.
    first, base, nose = next((shape for shape in found if (points[shape[0]] - points[shape[2]]).real > 0), found[0])
    if min(abs(points[0] - points[i]) for i in (first, base, nose)) > START_PART * polygons.box_size(points):
        return None
    count = len(points)
    loop.begin_at(first)
    return Aerofoil(loop, (base - first) % count if base != first else None, (nose - first) % count)


def shape_with_tail(points, turns, i):
    """(first point, point from which on it is the base, or first again, nose) if there is a trailing edge at the point i
    and the others are those of an aerofoil; else None."""
    run = tail_run(points, turns, i)
    if run is None:
        return None
    base, first = run
    count = len(points)
    tail = (points[base] + points[first]) / 2
    nose = max(range(count), key=lambda k: abs(points[k] - tail))
    to_nose, to_base = (nose - first) % count, (base - first) % count or count
    if min(to_nose, to_base - to_nose) < SIDE_SEGMENTS:
        return None
    axis = tail - points[nose]
    places = [(points[(first + k) % count] - points[nose]) / axis for k in range(to_base + 1)]
    thickness = max(z.imag for z in places) - min(z.imag for z in places)
    is_slim = abs(points[base] - points[first]) <= BASE_OF_THICKNESS * thickness * abs(axis) <= (
        BASE_OF_THICKNESS * THICKEST * abs(axis))
    runs_on = never_turns_back(places[: to_nose + 1]) and never_turns_back(places[to_nose:][::-1])
    sharpness = [abs(turns[0][(first + k) % count]) for k in range(to_base + 1)]
    has_corner = has_side_corner(places, sharpness) or has_flat_nose(places, sharpness, to_nose, thickness)
    if not is_slim or not runs_on or has_corner:
        return None
    return first, base, nose


def tail_run(points, turns, i):
    """(last point of one side, first point of the other) of a trailing edge at the point i: twice a sharp one, or both
    corners of a blunt one; else None."""
    count, (angles, errors) = len(points), turns
    if abs(angles[i]) >= TAIL_TURN:
        return (i, i) if corners.stands_out(angles, errors, i) else None
    reach = LONGEST_BASE * polygons.box_size(points)
    before, behind = (corner_beside(points, angles, i, step, reach) for step in (-1, 1))
    ends = [(before, behind)] if abs(angles[i]) < BASE_CORNER else [(before, i), (i, behind)]
    found = [end for end in ends if None not in end and abs(angles[end[0]] + angles[end[1]]) >= TAIL_TURN]
    return min(found, key=lambda end: (end[1] - end[0]) % count, default=None)


def corner_beside(points, angles, i, step, reach):
    """The next corner behind the point i in the direction of step, or None within this length."""
    count, length = len(points), 0.0
    for m in range(1, count):
        k = (i + m * step) % count
        length += abs(points[k] - points[k - step if step > 0 else (k + 1) % count])
        if length > reach:
            return None
        if abs(angles[k]) >= BASE_CORNER:
            return k
    return None


def never_turns_back(side):
    """Whether places, in chords from nose to trailing edge, go forward from the first to the last."""
    least = side[0].real
    for z in side:
        if z.real > least + BACKWARDS:
            return False
        least = min(least, z.real)
    return True


def has_side_corner(places, turns):
    inner = list(zip(places, turns))[1:-1]
    return any(turn > SIDE_CORNER and z.real > NOSE_PART for z, turn in inner)


def has_flat_nose(places, turns, nose, thickness):
    """Whether it ends in two corners as far apart as a rectangle's."""
    for k in (nose - 1, nose + 1):
        if min(turns[k], turns[nose]) >= NOSE_CORNER and abs(places[k] - places[nose]) > BASE_OF_THICKNESS * thickness:
            return True
    return False


def halves_joined(first, second):
    """One loop from two halves that both begin at the nose."""
    is_shared = first.points[0] == second.points[0]
    return Loop(first.points[::-1] + second.points[is_shared:], first.lines[::-1] + second.lines[is_shared:])


def divided_at_jump(loop):
    """Two parts of a loop, before and behind its longest segment."""
    steps = [abs(b - a) for a, b in zip(loop.points, loop.points[1:])]
    k = max(range(len(steps)), key=steps.__getitem__, default=0) + 1
    return Loop(loop.points[:k], loop.lines[:k]), Loop(loop.points[k:], loop.lines[k:])


def without_crossing(loop, rounding):
    """(loop, by how much its sides cross) of a loop that begins and ends at its trailing edge: where they cross there by
    rounding, both end at the middle of the first and last point. The loop itself and 0 where they do not."""
    points = loop.points
    size = polygons.box_size(points)
    reach, count = CROSSING_PART * size, len(points)
    met = meetings_at_ends(points, *(points_near(steps, reach) for steps in (points, points[::-1])), SAME * size)
    if not met or abs(points[0] - points[-1]) > reach:
        return loop, 0.0
    i, k = max(met, key=sum)
    overlap = max(depth(points[: i + 1], points[-2 - k :]), depth(points[count - 1 - k :], points[: i + 2]))
    if overlap > max(CROSSING * rounding, LEAST_CROSSING * size):
        return loop, 0.0
    middle, last = (points[0] + points[-1]) / 2, count - 1 - k
    return Loop([middle] + points[i + 1 : last], loop.lines[:1] + loop.lines[i + 1 : last]), overlap


def points_near(points, reach):
    """How many points there are before the first one that is farther from the first."""
    return next((k for k, z in enumerate(points) if abs(z - points[0]) > reach), 0)


def meetings_at_ends(points, heads, tails, tolerance):
    """The pairs (i, k) for which segment i from the first point on and segment k from the last one back meet."""
    segments = list(zip(points[:heads], points[1:])) + list(zip(points[:-1 - tails:-1], points[-2::-1]))
    pairs = ((i, k - heads) for i, k in BoxTree(segments).near_pairs(tolerance) if i < heads <= k)
    is_closed = abs(points[0] - points[-1]) <= tolerance  # so that the first segment and the last one meet anyway
    return [(i, k) for i, k in pairs if i + k >= is_closed
            and polygons.segments_meet(*segments[i], *segments[heads + k], tolerance)]


def depth(points, side):
    """The greatest distance of points from the other side."""
    return max(min(polygons.distance_to_segment(z, a, b) for a, b in zip(side, side[1:]) if a != b) for z in points)
