"""A curve along the wake of a body, which blocks do not cross: given by points, or computed for an aerofoil."""
import math

from command_frame import mistake
from outline import edges, point_files
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


def given(path, factor):
    """The smooth edges through the points of a file, which are scaled by the factor."""
    file = point_files.read_point_file(path)
    found = point_files.point_loops(file)
    if len(found) != 1 or len(found[0].points) < 2:
        raise file.fault(0, "expected the points of one line, at least two")
    points = [factor * z for z in found[0].points]
    for i, line in enumerate(found[0].lines[1:]):
        if points[i] == points[i + 1]:
            raise file.fault(line, "repeats the point before")
    return edges.smooth_edges(points, [NAME] * len(points), [], is_periodic=False)
