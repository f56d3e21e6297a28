"""Polygons with fewer points: those of straight walls, and others so that none left out is farther than a tolerance from
the new polygon (Ramer, Douglas and Peucker)."""
from outline import loops, polygons
from outline.loops import Loop

# A straight part is a wall, and kept as it is, if its length is so many tolerances, and so many times that of short
# segments (a quarter of all is shorter): not between any two points of a smooth line.
WALL, WALL_SEGMENTS = 10.0, 5.0
STRAIGHT = 0.05  # tolerances by which the points of a straight part may be beside it
SMALL = 4.0  # tolerances: loops that are no larger are kept as they are


def kept_points(points, tolerance, fixed=()):
    """The positions of the points of a closed polygon that a simplified one keeps, in order; `fixed` are among them."""
    everything = list(range(len(points)))
    if len(points) < 4 or polygons.box_size(points) <= SMALL * tolerance:
        return everything
    fixed = {end % len(points) for wall in walls(points, tolerance) for end in wall}.union(fixed)
    if len(fixed) < 2:
        start = min(fixed, default=max(range(len(points)), key=lambda i: abs(points[i] - points[0])))
        fixed = {start, max(range(len(points)), key=lambda i: abs(points[i] - points[start]))}
    anchors = sorted(fixed)
    closed = points + points[: anchors[0] + 1]
    kept = set(anchors)
    for a, b in zip(anchors, anchors[1:] + [anchors[0] + len(points)]):
        kept |= {i % len(points) for i in far_points(closed, a, b, tolerance)}
    return sorted(kept) if len(kept) > 2 else everything


def walls(points, tolerance):
    """(first, last point) of the straight parts of a closed polygon that are long; the last may be beyond its count."""
    count, found, start = len(points), [], 0
    closed = points + points
    short = sorted(abs(b - a) for a, b in zip(closed[:count], closed[1:]))[count // 4]
    least = max(WALL * tolerance, WALL_SEGMENTS * short)
    while start < count:
        end = end_of_straight(closed, start, STRAIGHT * tolerance, start + count)
        if abs(closed[end] - closed[start]) >= least:
            found.append((start, end))
        start = end
    return found


def end_of_straight(points, start, tolerance, last):
    """The farthest point up to which all points are so near to the line from the start to it: the directions in which the
    line passes all of them are a sector that shrinks."""
    low = high = None  # the sides of the sector
    for i in range(start + 1, last):
        way = points[i] - points[start]
        length = abs(way)
        if low is not None and (polygons.cross(low, way) < 0 or polygons.cross(way, high) < 0):
            return i - 1
        if length > tolerance:
            slope = tolerance / length
            right, left = way * complex(1, -slope), way * complex(1, slope)
            low = right if low is None or polygons.cross(low, right) > 0 else low
            high = left if high is None or polygons.cross(left, high) > 0 else high
    return last - 1


def far_points(points, first, last, tolerance):
    """Between these two, those that a simplified line keeps."""
    kept, stack = [], [(first, last)]
    while stack:
        a, b = stack.pop()
        if b - a < 2:
            continue
        start, end = points[a], points[b]
        distance = (lambda z: abs(z - start)) if start == end else lambda z: polygons.distance_to_segment(z, start, end)
        far = max(range(a + 1, b), key=lambda i: distance(points[i]))
        if distance(points[far]) > tolerance:
            kept.append(far)
            stack += [(a, far), (far, b)]
    return kept


def simplified(found, tolerance, same, fixed):
    """For each loop the positions of the points that it keeps, so that no two loops cross: where new segments meet (nearer
    than `same`), points come back. `fixed`: for each loop, positions that it keeps."""
    kept = [kept_points(loop.points, tolerance, of_loop) for loop, of_loop in zip(found, fixed)]
    while True:
        made = [part_of(loop, positions) for loop, positions in zip(found, kept)]
        number = {loop: k for k, loop in enumerate(made)}
        met = loops.meetings([segment for loop in made for segment in loops.segments(loop)], same)
        added = [set() for _ in found]
        for k, i in {(number[segment.loop], segment.i) for pair in met for segment in pair}:
            added[k] |= farthest_between(found[k].points, kept[k], i)
        if not any(added):
            return kept
        kept = [sorted(more.union(positions)) for more, positions in zip(added, kept)]


def part_of(loop, kept):
    return Loop([loop.points[i] for i in kept], [loop.lines[i] for i in kept])


def farthest_between(points, kept, k):
    """The point that is farthest from the segment k of the kept ones, among those that it replaces, if there are any."""
    a, b = kept[k], kept[(k + 1) % len(kept)]
    between = [i % len(points) for i in range(a + 1, b if b > a else b + len(points))]
    if not between:
        return set()
    return {max(between, key=lambda i: polygons.distance_to_segment(points[i], points[a], points[b]))}


def distance_left_out(points, kept):
    """The greatest of points that are not kept from the segments that replace them."""
    distance = 0.0
    for a, b in zip(kept, kept[1:] + [kept[0] + len(points)]):
        start, end = points[a], points[b % len(points)]
        distance = max([distance] + [polygons.distance_to_segment(points[i % len(points)], start, end)
                                     for i in range(a + 1, b)])
    return distance
