"""From a file of points to the edges of a face."""
from dataclasses import dataclass, field

from command_frame import mistake
from outline import corners, edges, fine_loops, loops, point_files, polygons, wake

BODY = "body"  # loops without a name in a far field
SAME = 1e-9  # points nearer to each other than this are one; in units of the largest distance of two points


@dataclass(frozen=True)
class Settings:
    """The options of points2step; None where a default depends on the points. Lengths are in units of the points."""

    format: str = "auto"
    corner_angle: float = None  # degrees; 30, for aerofoils 180
    is_straight: bool = False
    far_field: tuple = None  # kind, radius in chords
    chord: float = None  # to which the points are scaled
    name: str = None
    wake: str = None  # "auto", or a file of points


@dataclass(frozen=True)
class Outline:
    kind: str
    title: str
    num_points: int
    chord: float
    size: float  # the chord, or the radius of the far field
    edges: list  # of each loop, the outline first
    embedded: list  # edges inside the face
    warnings: list = field(default_factory=list)


@dataclass(frozen=True)
class Extent:
    """Where a far field is placed, and its unit of length."""

    chord: float
    middle: complex
    tail: complex  # the trailing edge, or the rightmost point, or the middle of a flat back
    direction: complex = 1 + 0j  # of the wake at the tail


def read_loops(file, requested_format):
    """(kind, loops, title, nose): the loops are closed and do not cross."""
    is_detected = requested_format == "auto" or not file.filled_lines()
    kind = point_files.detect_format(file) if is_detected else requested_format
    if kind == "points":
        found, title, nose = point_files.point_loops(file), "points", None
    else:
        loop, title, nose = point_files.aerofoil(file, kind == "lednicer")
        found = [loop]
    check_loops(file, found, is_aerofoil=kind != "points")
    return kind, found, title, nose


def check_loops(file, found, is_aerofoil):
    size = polygons.largest_distance([z for loop in found for z in loop.points])
    if not 1e-100 < size < 1e100:
        raise file.fault(found[0].lines[0], f"the largest distance of two points is {size:g}: scale the points")
    tolerance = SAME * size
    for loop in found:
        was_closed = loops.close(file, loop, tolerance)
        if is_aerofoil and not was_closed:
            loop.corners.add(len(loop.points) - 1)
    for loop in found:
        loops.refuse_reversals(file, loop, tolerance)
    loops.refuse_crossings(file, found, tolerance)


def name_loops(found, words):
    names = [word.strip() for word in words.split(",")]
    if len(names) != len(found):
        raise mistake(f"--name {words}: {len(names)} names for {len(found)} loop{'s' * (len(found) != 1)}")
    for loop, name in zip(found, names):
        loop.names = [name] * len(loop.points)


def extent_of_points(found):
    """The corners of the loops are known."""
    points = [z for loop in found for z in loop.points]
    across, up = [z.real for z in points], [z.imag for z in points]
    middle = complex(min(across) + max(across), min(up) + max(up)) / 2
    size = polygons.largest_distance(points)
    return Extent(size, middle, tail_of_points(found, SAME * size))


def tail_of_points(found, tolerance):
    """The rightmost point, or the middle of a flat back there, or of a smooth curve between two points as far right."""
    loop, i = max(((loop, i) for loop in found for i in range(len(loop.points))),
                  key=lambda place: (place[0].points[place[1]].real, place[0].points[place[1]].imag))
    tail = loop.points[i]
    if i in loop.corners:
        back = corners.back_middle(loop, i, tolerance)
        return back if back is not None else tail
    for beside in (loop.points[i - 1], loop.points[(i + 1) % len(loop.points)]):
        if tail.real - beside.real <= tolerance:
            return max(fine_loops.fine_loop(edges.loop_edges(loop)).points, key=lambda z: z.real)
    return tail


def extent_of_aerofoil(file, loop, nose, name):
    """Names and marks its edges as well."""
    front, tail = corners.mark_aerofoil(file, loop, nose, name + "_" if name is not None else "")
    direction = wake.tail_direction(loop.points, is_blunt=len(loop.corners) > 1)
    return Extent(abs(tail - front), (front + tail) / 2, tail, direction)


def wake_edges(settings, extent, factor, bodies):
    """(edges, warnings): the wake as edges inside the face, in which the bodies are loops of edges."""
    if settings.wake is None:
        return [], []
    if settings.far_field is None:
        raise mistake("--wake needs --farfield, in which it ends")
    shape, reach = settings.far_field
    chord, middle, tail = (factor * length for length in (extent.chord, extent.middle, extent.tail))
    if settings.wake != "auto":
        return wake.given(settings.wake, factor, lambda z: wake.is_inside(shape, reach * chord, middle, tail, z),
                          reach * chord, chord, [fine_loops.fine_loop(body) for body in bodies])
    return [wake.computed(shape, reach * chord, chord, middle, tail, extent.direction)], []


def build_outline(file, settings):
    """The edges of the face that the points of the file describe."""
    kind, found, title, nose = read_loops(file, settings.format)
    is_points = kind == "points"
    if is_points and settings.name is not None:
        name_loops(found, settings.name)
    elif is_points and settings.far_field is not None:
        name_loops(found, ",".join([BODY] * len(found)))
    angle = settings.corner_angle if settings.corner_angle is not None else 30.0 if is_points else 180.0
    extent_of_wing = None if is_points else extent_of_aerofoil(file, found[0], nose, settings.name)
    for loop in found:
        corners.mark_corners(loop, 0.0 if settings.is_straight else angle)
    extent = extent_of_wing or extent_of_points(found)
    factor = 1.0 if settings.chord is None else settings.chord / extent.chord
    for loop in found:
        loop.points = [factor * z for z in loop.points]
    found = loops.arrange(file, found, settings.far_field is not None)
    all_edges = [edges.straight_edges(loop) if settings.is_straight else edges.loop_edges(loop) for loop in found]
    embedded, warnings = wake_edges(settings, extent, factor, all_edges)
    chord = size = factor * extent.chord
    if settings.far_field is not None:
        shape, reach = settings.far_field
        size = reach * chord
        all_edges.insert(0, edges.far_field_edges(shape, size, factor * extent.middle, factor * extent.tail))
    return Outline(kind, title, sum(len(loop.points) for loop in found), chord, size, all_edges, embedded,
                   warnings)
