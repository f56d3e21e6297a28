"""A curve along the wake of a body, which blocks do not cross: given by points, or computed for an aerofoil."""
import math

from command_frame import mistake
from outline import near_polygon, point_files
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


def cut_at_outline(points, inside):
    """The points up to the outline of the far field, if they leave it."""
    outside = next((i for i, z in enumerate(points) if not inside(z)), None)
    if not outside:
        return points
    near, far = points[outside - 1], points[outside]
    while (middle := (near + far) / 2) not in (near, far):
        near, far = (middle, far) if inside(middle) else (near, middle)
    last = outside if abs(near - points[outside - 1]) > 1e-9 * abs(points[outside] - points[outside - 1]) else outside - 1
    return points[:last] + [near]


def given(path, factor, inside):
    """The smooth edges through the points of a file, which are scaled by the factor, up to the outline of the far
    field."""
    file = point_files.read_point_file(path)
    found = point_files.point_loops(file)
    if len(found) != 1 or len(found[0].points) < 2:
        raise file.fault(0, "expected the points of one line, at least two")
    points = [factor * z for z in found[0].points]
    for i, line in enumerate(found[0].lines[1:]):
        if points[i] == points[i + 1]:
            raise file.fault(line, "repeats the point before")
    points = cut_at_outline(points, inside)
    if len(points) < 2 or not inside(points[0]):
        raise file.fault(found[0].lines[0], "the wake does not begin at the body, inside the far field")
    return near_polygon.smooth_edges(points, NAME)
