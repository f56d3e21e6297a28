"""Closed loops of points: closing, checks, and their arrangement as an outline and its holes."""
from outline import polygons
from outline.box_tree import BoxTree


class Loop:
    """Points of a closed loop; segment i runs from point i to the next. `lines`: the line of each point in its file.
    `names`: of the segments. `corners`: points where a smooth curve ends. `joints`: points where only an edge ends.
    `walls`: segments on straight lines, into which curves beside them turn smoothly; each with the number of its line."""

    def __init__(self, points, lines):
        self.points, self.lines = points, lines
        self.names = [""] * len(points)
        self.corners, self.joints, self.walls = set(), set(), {}

    def reverse(self):
        last = len(self.points) - 1
        self.points, self.lines = self.points[::-1], self.lines[::-1]
        self.names = [self.names[(last - 1 - i) % len(self.names)] for i in range(len(self.names))]
        self.walls = {(last - 1 - i) % len(self.points): wall for i, wall in self.walls.items()}
        self.corners, self.joints = ({last - i for i in marked} for marked in (self.corners, self.joints))

    def remove_points(self, removed):
        """`removed`: their positions. Nothing else is known of the points yet."""
        for values in (self.points, self.lines, self.names):
            values[:] = [value for i, value in enumerate(values) if i not in removed]

    def begin_at(self, start):
        """Nothing else is known of the points yet."""
        for values in (self.points, self.lines, self.names):
            values[:] = values[start:] + values[:start]


def close(file, loop, tolerance):
    """Removes the last points that are the first one again, and points that repeat the one before. Returns (whether the
    first point was repeated at the end, the lines of the others). Refuses loops of less than three points."""
    count = len(loop.points)
    is_repeated = count > 1 and abs(loop.points[0] - loop.points[-1]) <= tolerance
    kept = [0]
    for i in range(1, count):
        if abs(loop.points[i] - loop.points[kept[-1]]) > tolerance:
            kept.append(i)
    while len(kept) > 1 and abs(loop.points[kept[-1]] - loop.points[0]) <= tolerance:
        kept.pop()
    if len(kept) < 3:
        raise file.fault(loop.lines[0], f"a loop needs three different points, this one has {len(kept)}")
    left_out = sorted(set(range(count)) - set(kept))
    lines = [loop.lines[i] for i in left_out if not (is_repeated and i == count - 1)]
    loop.remove_points(set(left_out))
    return is_repeated, lines


class Segment:
    """Segment i of a loop, from a to b."""

    def __init__(self, loop, i):
        self.loop, self.i = loop, i
        self.a, self.b = loop.points[i], loop.points[(i + 1) % len(loop.points)]

    def is_next_to(self, other):
        count = len(self.loop.points)
        return self.loop is other.loop and (self.i - other.i) % count in (0, 1, count - 1)

    def meets(self, other, tolerance):
        return not self.is_next_to(other) and polygons.segments_meet(self.a, self.b, other.a, other.b, tolerance)

    @property
    def line(self):
        return self.loop.lines[self.i]


def refuse_reversals(file, loop, tolerance, is_closed=True):
    """Refuses a loop, or an open line, with a segment that turns back onto the one before."""
    count = len(loop.points)
    for i in range(count if is_closed else count - 2):
        a, b, c = (loop.points[(i + k) % count] for k in range(3))
        if min(polygons.distance_to_segment(c, a, b), polygons.distance_to_segment(a, b, c)) <= tolerance:
            raise file.fault(loop.lines[(i + 1) % count], f"the {'loop' if is_closed else 'line'} turns back on itself")


def segments(loop, is_closed=True):
    return [Segment(loop, i) for i in range(len(loop.points) - (not is_closed))]


def refuse_crossings(file, loops, tolerance):
    """Refuses polygons that cross or touch themselves or each other."""
    refuse_meetings(file, [segment for loop in loops for segment in segments(loop)], tolerance,
                    "the loop crosses or touches itself")


def meetings(found, tolerance):
    """The pairs of segments that meet although they are not neighbours."""
    for i, k in BoxTree([(segment.a, segment.b) for segment in found]).near_pairs(tolerance):
        if found[i].meets(found[k], tolerance):
            yield found[i], found[k]


def refuse_meetings(file, found, tolerance, of_one_loop):
    """Refuses segments that meet although they are not neighbours, the first in the file. `of_one_loop`: what that means
    if they belong to one loop."""
    worst = min((tuple(sorted(pair, key=lambda segment: -segment.line)) for pair in meetings(found, tolerance)),
                key=lambda pair: (pair[0].line, pair[1].line), default=None)
    if worst:
        what = of_one_loop if worst[0].loop is worst[1].loop else "two loops cross or touch"
        raise file.fault(worst[0].line, f"{what}: the segment from here meets the segment from line {worst[1].line}")


def arrange(file, loops, has_far_field):
    """The outline first and counter-clockwise, then the holes clockwise. With a far field all loops are holes."""
    outline = None if has_far_field else max(loops, key=lambda loop: abs(polygons.area(loop.points)))
    for loop in loops:
        if (polygons.area(loop.points) > 0) != (loop is outline):
            loop.reverse()
    holes = [loop for loop in loops if loop is not outline]
    found = [segment for loop in loops for segment in segments(loop)]
    tree = BoxTree([(segment.a, segment.b) for segment in found])
    for hole in holes:
        around = loops_around(hole.points[0], [found[i] for i in tree.right_of(hole.points[0])], hole)
        if outline and outline not in around:
            raise file.fault(min(hole.lines), "this loop is not inside the largest one")
        for other in around:
            if other is not outline:
                raise file.fault(min(hole.lines), f"this loop lies inside the hole that begins in line {min(other.lines)}")
    return ([outline] if outline else []) + holes


def loops_around(z, found, own):
    """The other loops of which an odd number of the segments found, those at the height of z, are to the right of it."""
    counts = {}
    for segment in found:
        if segment.loop is not own and polygons.is_right_of(z, segment.a, segment.b):
            counts[segment.loop] = counts.get(segment.loop, 0) + 1
    return [loop for loop, count in counts.items() if count % 2]
