"""A wake given by points begins at the body and ends at the far field: its ends are cut off or continued."""
import bisect

from outline import fine_loops, polygons, splines

GAP = 0.05  # the greatest that is closed without a warning: in chords, or in lengths of the segment at this end
SMALL = 1e-5  # chords: parts of a wake inside a body that are shorter are none
AT_CORNER = 1e-4  # chords: a wake that begins so near to a corner of the body begins there


class Along:
    """Positions along an open polygon, by the length from its start."""

    def __init__(self, points):
        self.points, self.lengths = points, splines.chord_lengths(points)

    def segment(self, length):
        return min(bisect.bisect_right(self.lengths, length), len(self.points) - 1) - 1

    def point(self, length):
        i = self.segment(length)
        fraction = (length - self.lengths[i]) / (self.lengths[i + 1] - self.lengths[i])
        return self.points[i] + fraction * (self.points[i + 1] - self.points[i])

    def rest(self, length):
        """The polygon from this position on."""
        i = self.segment(length)
        return [self.point(length)] + self.points[i + 1 :]


def fractions_met(a, b, polygon):
    """Where the segment from a to b meets the closed polygon, as fractions of its length."""
    for c, d in zip(polygon, polygon[1:] + polygon[:1]):
        if (polygons.side(a, b, c) > 0) != (polygons.side(a, b, d) > 0):
            fraction = polygons.cross(c - a, d - c) / polygons.cross(b - a, d - c)
            if 0 <= fraction <= 1:
                yield fraction


def meetings(along, bodies):
    """The lengths at which the polygon meets outlines of bodies, in order."""
    found = []
    for i, (a, b) in enumerate(zip(along.points, along.points[1:])):
        for body in bodies:
            if fine_loops.boxes_meet(fine_loops.box_of([a, b]), body.box):
                step = abs(b - a)
                found += [along.lengths[i] + u * step for u in fractions_met(a, b, body.points)]
    return sorted(found)


def parts_inside(points, bodies, small):
    """(first, last) of the parts of the polygon inside bodies, by their lengths; parts that are `small` are left out."""
    along = Along(points)
    ends = [0.0] + meetings(along, bodies) + [along.lengths[-1]]
    parts = []
    for first, last in zip(ends, ends[1:]):
        middle = along.point((first + last) / 2)
        if last - first <= small or not any(polygons.is_inside(middle, body.points) for body in bodies):
            continue
        if parts and first - parts[-1][1] <= small:
            first = parts.pop()[0]
        parts.append((first, last))
    return parts


def begin_at_body(points, bodies, chord):
    """The polygon without its beginning inside a body, from the nearest point of a body on; and a warning if that is far
    away, else None."""
    parts = parts_inside(points, bodies, SMALL * chord)
    if parts and parts[0][0] <= SMALL * chord:
        along = Along(points)
        if along.lengths[-1] - parts[0][1] <= SMALL * chord:
            return [], None
        points = along.rest(parts[0][1])
    start = nearest_start(points[0], bodies, chord)
    gap = abs(start - points[0])
    if gap <= 0.25 * abs(points[1] - points[0]) and is_small(gap, points[1] - points[0], chord):
        return [start] + points[1:], None
    warning = None if is_small(gap, points[1] - points[0], chord) else (
        f"the wake begins at {place(points[0])}, {gap:.4g} away from the body: it is continued to {place(start)}")
    return [start] + points, warning


def nearest_start(z, bodies, chord):
    """The nearest point of the bodies, or a corner beside it, no farther from it than it is away from z: a wake begins at
    the tip of a wedge, not beside it. A quarter of the edges at the corner is the limit, so that a narrow edge keeps its
    middle."""
    nearest = min((body.nearest(z) for body in bodies), key=lambda w: abs(w - z))
    reach = max(abs(nearest - z), AT_CORNER * chord)
    beside = lambda corner: abs(corner - nearest)
    corners = [corner for body in bodies for corner, length in body.corners if beside(corner) <= min(reach, length / 4)]
    return min(corners, key=beside, default=nearest)


def is_small(gap, segment, chord):
    return gap <= GAP * max(chord, abs(segment))


def end_at_far_field(points, inside, size, chord):
    """The polygon up to the outline of the far field, of which the whole has this size; and a warning if it was continued
    by far, else None. The first point lies inside."""
    outside = next((i for i, z in enumerate(points) if not inside(z)), None)
    if outside:
        end = last_inside(points[outside - 1], points[outside], inside)
        step = abs(points[outside] - points[outside - 1])
        last = outside if abs(end - points[outside - 1]) > 1e-9 * step else outside - 1
        return points[:last] + [end], None
    segment = points[-1] - points[-2]
    end = last_inside(points[-1], points[-1] + 2 * size * segment / abs(segment), inside)
    gap = abs(end - points[-1])
    if gap <= 1e-9 * size:
        return points, None
    if is_small(gap, segment, chord):
        return points[:-1] + [end], None
    return points + [end], (f"the wake ends at {place(points[-1])}, {gap:.4g} before the far field: it is continued "
                            f"straight to {place(end)}")


def last_inside(near, far, inside):
    """The last point on the segment from `near`, inside, to `far`, outside."""
    while (middle := (near + far) / 2) not in (near, far):
        near, far = (middle, far) if inside(middle) else (near, middle)
    return near


def place(z):
    return f"({z.real:.6g}, {z.imag:.6g})"
