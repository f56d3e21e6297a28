"""Closed loops of points: closing, checks, and their arrangement as an outline and its holes."""
from outline import polygons


class Loop:
    """Points of a closed loop; segment i runs from point i to the next. `lines`: the line of each point in its file.
    `names`: of the segments. `corners`: points where a smooth curve ends. `joints`: points where only an edge ends."""

    def __init__(self, points, lines):
        self.points, self.lines = points, lines
        self.names = [""] * len(points)
        self.corners, self.joints = set(), set()

    def reverse(self):
        last = len(self.points) - 1
        self.points, self.lines = self.points[::-1], self.lines[::-1]
        self.names = [self.names[(last - 1 - i) % len(self.names)] for i in range(len(self.names))]
        self.corners, self.joints = ({last - i for i in marked} for marked in (self.corners, self.joints))

    def remove_last_point(self):
        for values in (self.points, self.lines, self.names):
            values.pop()


def close(file, loop, tolerance):
    """Removes the last point if it is the first one again; returns whether it was. Refuses repeated points and loops
    of less than three points."""
    is_repeated = len(loop.points) > 1 and abs(loop.points[0] - loop.points[-1]) <= tolerance
    if is_repeated:
        loop.remove_last_point()
    if len(loop.points) < 3:
        raise file.fault(loop.lines[0], f"a loop needs three different points, this one has {len(loop.points)}")
    for i in range(1, len(loop.points)):
        if abs(loop.points[i] - loop.points[i - 1]) <= tolerance:
            raise file.fault(loop.lines[i], f"repeats the point of line {loop.lines[i - 1]}")
    return is_repeated


class Segment:
    """Segment i of a loop, from a to b."""

    def __init__(self, loop, i):
        self.loop, self.i = loop, i
        self.a, self.b = loop.points[i], loop.points[(i + 1) % len(loop.points)]
        self.left, self.right = sorted((self.a.real, self.b.real))
        self.low, self.high = sorted((self.a.imag, self.b.imag))

    def is_next_to(self, other):
        count = len(self.loop.points)
        return self.loop is other.loop and (self.i - other.i) % count in (0, 1, count - 1)

    def meets(self, other, tolerance):
        if self.is_next_to(other) or other.low > self.high + tolerance or other.high < self.low - tolerance:
            return False
        return polygons.segments_meet(self.a, self.b, other.a, other.b, tolerance)


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


def refuse_meetings(file, found, tolerance, of_one_loop):
    """Refuses segments that meet although they are not neighbours: a sweep from left to right. `of_one_loop`: what that
    means if they belong to one loop."""
    found = sorted(found, key=lambda segment: segment.left)
    for m, segment in enumerate(found):
        for other in found[m + 1 :]:
            if other.left > segment.right + tolerance:
                break
            if segment.meets(other, tolerance):
                what = of_one_loop if segment.loop is other.loop else "two loops cross or touch"
                first, second = sorted((segment.loop.lines[segment.i], other.loop.lines[other.i]))
                raise file.fault(second, f"{what}: the segment from here meets the segment from line {first}")


def arrange(file, loops, has_far_field):
    """The outline first and counter-clockwise, then the holes clockwise. With a far field all loops are holes."""
    outline = None if has_far_field else max(loops, key=lambda loop: abs(polygons.area(loop.points)))
    for loop in loops:
        if (polygons.area(loop.points) > 0) != (loop is outline):
            loop.reverse()
    holes = [loop for loop in loops if loop is not outline]
    for hole in holes:
        if outline and not polygons.is_inside(hole.points[0], outline.points):
            raise file.fault(min(hole.lines), "this loop is not inside the largest one")
        for other in holes:
            if other is not hole and polygons.is_inside(hole.points[0], other.points):
                raise file.fault(min(hole.lines), f"this loop lies inside the hole that begins in line {min(other.lines)}")
    return ([outline] if outline else []) + holes
