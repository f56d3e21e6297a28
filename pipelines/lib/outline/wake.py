"""A curve along the wake of a body, which blocks do not cross: given by points, or computed for an aerofoil."""
import math

from command_frame import mistake
from outline import fine_loops, loops, near_polygon, point_files, point_rows, polygons, wake_ends
from outline.edges import Spline

NAME = "wake"


def tail_direction(points, is_blunt):
    """Along the bisector of the trailing edge, away from the aerofoil whose points run from there over the nose."""
    lower = points[-1] - points[-2] if is_blunt else points[0] - points[-1]
    upper = points[0] - points[1]
    both = upper / abs(upper) + lower / abs(lower)
    return both / abs(both) if abs(both) > 1e-6 else 1 + 0j


def end_of(shape, reach, middle, tail, height):
    """Where the line at this height above the origin leaves the far field downstream."""
    if shape == "circle":
        return complex(middle.real + math.sqrt(reach**2 - (height - middle.imag) ** 2), height)
    return complex((middle if shape == "box" else tail).real + reach, height)


def computed(shape, reach, chord, middle, tail, direction):
    """A cubic that starts at the tail in this direction and ends at the far field downstream, in the direction of x. It
    gets there as far aside as a straight line does in one chord."""
    if direction.real <= 0.5:
        raise mistake("--wake auto: the trailing edge does not point in the direction of x: give the points of the wake")
    start = tail + direction / direction.real * chord
    end = end_of(shape, reach, middle, tail, start.imag)
    poles = [tail, start, end - (end.real - start.real) / 2, end]
    return Spline(poles, [0.0, 1.0], NAME)


def is_inside(shape, reach, middle, tail, z):
    """Whether z lies in the far field, or on its outline."""
    way = z - (tail if shape == "cgrid" else middle)
    is_round = shape == "circle" or shape == "cgrid" and way.real < 0
    return (abs(way) if is_round else max(abs(way.real), abs(way.imag))) <= reach


def read_points(path, factor):
    """(file, lines of the points, points of the wake, scaled): they do not repeat, cross or turn back."""
    file = point_files.read_point_file(path)
    found = point_rows.point_loops(file)
    if len(found) != 1 or len(found[0].points) < 2:
        raise file.fault(0, "expected the points of one line, at least two")
    points, lines = found[0].points, found[0].lines
    for i, line in enumerate(lines[1:]):
        if points[i] == points[i + 1]:
            raise file.fault(line, "repeats the point before")
    tolerance = 1e-9 * polygons.largest_distance(points)
    loops.refuse_reversals(file, found[0], tolerance, is_closed=False)
    loops.refuse_meetings(file, loops.segments(found[0], is_closed=False), tolerance, "the wake crosses or touches itself")
    return file, lines, [factor * z for z in points]


def given(path, factor, inside, size, chord, bodies):
    """(edges, warnings): smooth edges through the points of a file, which are scaled by the factor, from the body to the
    outline of the far field, which has this size and encloses the `bodies` (FineLoop)."""
    file, lines, points = read_points(path, factor)
    if not inside(points[0]):
        raise file.fault(lines[0], "the wake does not begin at the body, inside the far field")
    points, begun = wake_ends.begin_at_body(points, bodies, chord)
    if not points:
        raise file.fault(lines[-1], "the wake ends inside the body, where it begins")
    points, ended = wake_ends.end_at_far_field(points, inside, size, chord)
    refuse_body(file, "the wake crosses the body", points, bodies, chord)
    smooth = near_polygon.smooth_edges(points, NAME)
    curve = [points[0]] + [z for edge in smooth for z in fine_loops.fine_edge(edge)[1:]]
    refuse_body(file, "the smooth curve through the points of the wake crosses the body", curve, bodies, chord)
    return smooth, [f"{file.name}: {warning}" for warning in (begun, ended) if warning]


def refuse_body(file, what, points, bodies, chord):
    """Refuses a polygon that has a part inside a body."""
    for first, last in wake_ends.parts_inside(points, bodies, wake_ends.SMALL * chord):
        along = wake_ends.Along(points)
        ends = " to ".join(wake_ends.place(along.point(length)) for length in (first, last))
        raise file.fault(0, f"{what} from {ends}: begin it where it leaves the body, and lead it around others")
