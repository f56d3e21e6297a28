"""From a file of points to the edges of a face."""
import math
from dataclasses import dataclass, field

from command_frame import mistake
from outline import corners, edges, fine_loops, forms, loops, polygons, simplify, wake
from outline.fit import Fit
from outline.forms import SAME

BODY = "body"  # loops without a name in a far field
# Many corners with both neighbours at such a part of the largest distance are perhaps noise.
MANY_CORNERS, NEAR_CORNERS = 20, 0.02


@dataclass(frozen=True)
class Settings:
    """The options of points2step; None where a default depends on the points. Lengths are in units of the points."""

    format: str = "auto"
    corner_angle: float = None  # degrees; None: corners.mark_sharp_corners
    is_straight: bool = False
    tolerance: float = 0.0  # of curves; 0: that of near_spline.arc_limits
    simplify: float = 0.0  # the greatest distance of points that are left out; 0: none are
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
    notes: list = field(default_factory=list)  # sentences on what was read and how the curves fit it


@dataclass(frozen=True)
class Extent:
    """Where a far field is placed, and its unit of length."""

    chord: float
    middle: complex
    tail: complex  # the trailing edge, or the rightmost point, or the middle of a flat back
    direction: complex = 1 + 0j  # of the wake at the tail


def name_loops(found, words):
    names = [word.strip() for word in words.split(",")]
    if len(names) != len(found):
        raise mistake(f"--name {words}: {len(names)} names for {len(found)} loop{'s' * (len(found) != 1)}")
    for loop, name in zip(found, names):
        loop.names = [name] * len(loop.points)


def extent_of_points(found):
    """The corners of the loops are known."""
    points = [z for loop in found for z in loop.points]
    size = polygons.largest_distance(points)
    return Extent(size, middle_of(points), tail_of_points(found, SAME * size))


def middle_of(points):
    """Of the box around them."""
    across, up = [z.real for z in points], [z.imag for z in points]
    return complex(min(across) + max(across), min(up) + max(up)) / 2


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


def extent_of_aerofoil(file, shape, name):
    """Names and marks its edges as well."""
    front, tail = corners.mark_aerofoil(file, shape.loop, shape.base, shape.nose, name + "_" if name is not None else "")
    return Extent(abs(tail - front), (front + tail) / 2, tail, direction_at(shape))


def direction_at(shape):
    """Of the wake of an aerofoil."""
    points = shape.loop.points
    return wake.tail_direction(points[: None if shape.base is None else shape.base + 1], is_blunt=shape.base is not None)


def extent_of_aerofoils(shapes):
    """Marks the corners of their trailing edges; the wake begins at the rightmost one."""
    for shape in shapes:
        shape.loop.corners |= {0} if shape.base is None else {0, shape.base}
    last = max(shapes, key=lambda shape: shape.loop.points[0].real)
    tail = (last.loop.points[0] + last.loop.points[last.base or 0]) / 2
    points = [z for shape in shapes for z in shape.loop.points]
    return Extent(polygons.largest_distance(points), middle_of(points), tail, direction_at(last))


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


def simplify_form(form, tolerance):
    """Leaves out points of its loops, and adds a note."""
    size = polygons.largest_distance([z for loop in form.loops for z in loop.points])
    fixed = [{0, shape.nose or 0, shape.base or 0} for shape in form.aerofoils] or [()] * len(form.loops)
    kept = simplify.simplified(form.loops, tolerance, SAME * size, fixed)
    total = sum(len(loop.points) for loop in form.loops)
    for loop, positions in zip(form.loops, kept):
        loop.walls = {positions.index(a % len(loop.points)): a for a, _ in simplify.walls(loop.points, tolerance)}
    distance = max(simplify.distance_left_out(loop.points, positions) for loop, positions in zip(form.loops, kept))
    for shape, positions in zip(form.aerofoils, kept):
        shape.base = None if shape.base is None else positions.index(shape.base)
        shape.nose = None if shape.nose is None else positions.index(shape.nose)
    for loop, positions in zip(form.loops, kept):
        loop.remove_points(set(range(len(loop.points))).difference(positions))
    form.notes.append(f"{total - sum(map(len, kept))} of {total} points are left out, which are up to {distance:.3g} "
                      "beside the simplified outline")


def mark_corners(form, settings):
    """Of loops whose trailing edges are marked."""
    rounding = max(form.rounding, settings.simplify)
    for loop in form.loops:
        if settings.is_straight:
            corners.mark_corners(loop, 0.0)
        elif settings.tolerance > 0:
            mark_corners_of_noise(loop, settings, bool(form.aerofoils))
        elif settings.corner_angle is not None:
            corners.mark_corners(loop, settings.corner_angle)
        else:
            corners.mark_sharp_corners(loop, rounding, bool(form.aerofoils))


def note_on_noise(form, settings):
    """A sentence if many corners are close together."""
    size = polygons.largest_distance([z for loop in form.loops for z in loop.points])
    count = 0
    for loop in form.loops:
        ends = loop.points[1:] + loop.points[:1]
        is_short = [abs(b - a) < NEAR_CORNERS * size for a, b in zip(loop.points, ends)]
        count += sum(is_short[i] and is_short[i - 1] for i in loop.corners)
    if count > MANY_CORNERS and not settings.is_straight:
        form.notes.append(f"{count} corners are closer together than {100 * NEAR_CORNERS:g} % of the size: if they are "
                          "noise, give --points-tolerance T or --simplify-outline T")


def mark_corners_of_noise(loop, settings, is_aerofoil):
    """Of the loop without points that are noise: no farther from the others than the tolerance."""
    if settings.simplify == 0:
        count = len(loop.points)
        loop.walls = {i % count: a for a, b in simplify.walls(loop.points, settings.tolerance) for i in range(a, b)}
    kept = simplify.kept_points(loop.points, settings.tolerance, loop.corners | loop.joints)
    plain = simplify.part_of(loop, kept)
    if settings.corner_angle is not None:
        corners.mark_corners(plain, settings.corner_angle)
    else:
        corners.mark_sharp_corners(plain, settings.tolerance, is_aerofoil)
    loop.corners.update(kept[i] for i in plain.corners)


def placed(form, settings):
    """The extent of the shape. Names its edges and marks the corners."""
    is_wing = len(form.aerofoils) == 1
    if settings.name is not None and not is_wing:
        name_loops(form.loops, settings.name)
    elif settings.far_field is not None and not is_wing:
        name_loops(form.loops, ",".join([BODY] * len(form.loops)))
    extent = extent_of_aerofoil(form.file, form.aerofoils[0], settings.name) if is_wing else None
    if len(form.aerofoils) > 1:
        extent = extent_of_aerofoils(form.aerofoils)
    mark_corners(form, settings)
    note_on_noise(form, settings)
    return extent or extent_of_points(form.loops)


def loop_edges(found, settings, factor, notes):
    """The edges of each loop; adds a note on how far they are from the points."""
    if settings.is_straight:
        return [edges.straight_edges(loop) for loop in found]
    limit = factor * settings.simplify or math.inf
    nearness = edges.Nearness(factor * settings.tolerance, limit, Fit(factor))
    made = [edges.loop_edges(loop, nearness) for loop in found]
    notes += nearness.fit.sentences()
    return made


def build_outline(file, settings):
    """The edges of the face that the points of the file describe. Throws Failure."""
    form = forms.read_form(file, settings.format)
    if settings.simplify > 0:
        simplify_form(form, settings.simplify)
    extent = placed(form, settings)
    factor = 1.0 if settings.chord is None else settings.chord / extent.chord
    for loop in form.loops:
        loop.points = [factor * z for z in loop.points]
    found = loops.arrange(file, form.loops, settings.far_field is not None)
    all_edges = loop_edges(found, settings, factor, form.notes)
    embedded, warnings = wake_edges(settings, extent, factor, all_edges)
    chord = size = factor * extent.chord
    if settings.far_field is not None:
        shape, reach = settings.far_field
        size = reach * chord
        all_edges.insert(0, edges.far_field_edges(shape, size, factor * extent.middle, factor * extent.tail))
    return Outline(form.kind, form.title, sum(len(loop.points) for loop in found), chord, size, all_edges, embedded,
                   warnings, form.notes)
