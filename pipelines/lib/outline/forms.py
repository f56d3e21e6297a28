"""What a file of points describes: loops, or an aerofoil in one of its formats. Only the points decide, no heading."""
from dataclasses import dataclass, field

from outline import aerofoils, loops, polygons
from outline.aerofoils import Aerofoil
from outline.point_rows import read_rows

SAME = 1e-9  # points nearer to each other than this are one; in units of the largest distance of two points


@dataclass
class Form:
    file: object  # PointFile
    kind: str  # points, selig, lednicer
    loops: list
    aerofoils: list  # of Aerofoil, one for each loop; empty for other shapes
    title: str
    rounding: float  # the greatest rounding error of a coordinate
    notes: list = field(default_factory=list)  # sentences on what was read, the form first


def read_form(file, requested):
    """The form of a file, detected or as requested (one of FORMATS). The loops are closed, without repeated points, and
    do not cross. Throws Failure."""
    rows = read_rows(file)
    size = polygons.largest_distance(rows.joined().points)
    if not 1e-100 < size < 1e100:
        raise file.fault(rows.loops[0].lines[0], f"the largest distance of two points is {size:g}: scale the points")
    if requested == "auto":
        form = detected(file, rows, SAME * size)
    elif requested == "points":
        form = points_form(file, rows, SAME * size)
    else:
        form = requested_aerofoil(file, rows, requested, SAME * size)
    for loop in form.loops:
        loops.refuse_reversals(file, loop, SAME * size)
    loops.refuse_crossings(file, form.loops, SAME * size)
    return form


def detected(file, rows, tolerance):
    for kind, candidates in possible_aerofoils(file, rows):
        notes, shapes = [], []
        for loop in candidates:
            shape = aerofoil_of(file, loop, rows.rounding, tolerance, notes)
            if shape is None:
                break
            shapes.append(shape)
        else:
            return aerofoil_form(file, rows, kind, shapes, notes)
    return points_form(file, rows, tolerance)


def possible_aerofoils(file, rows):
    """(kind, loops) that may be those of aerofoils, the plainest first."""
    counted = without_counts(file, rows)
    if counted is not None:
        yield "lednicer", [counted]
    yield "selig", rows.loops
    if len(rows.loops) == 2:
        yield "lednicer", [aerofoils.halves_joined(*rows.loops)]
    parts = aerofoils.divided_at_jump(rows.loops[0])
    if len(rows.loops) == 1 and all(part.points for part in parts):
        yield "lednicer", [aerofoils.halves_joined(*parts)]
    if len(rows.loops) > 1:
        yield "selig", [rows.joined()]


def is_pair_of_counts(z):
    return min(z.real, z.imag) >= 2 and z.real == int(z.real) and z.imag == int(z.imag)


def without_counts(file, rows, must_be=False):
    """The joined halves if the first row holds their numbers of points, as in Lednicer's format; else None, or a failure
    if they must be there."""
    whole = rows.joined()
    points, lines = whole.points[1:], whole.lines[1:]
    if not is_pair_of_counts(whole.points[0]):
        if must_be:
            raise file.fault(whole.lines[0], "expected the numbers of points of the upper and lower side")
        return None
    upper, lower = int(whole.points[0].real), int(whole.points[0].imag)
    if upper + lower != len(points):
        if must_be:
            raise file.fault(whole.lines[0], f"expected {upper} + {lower} points, found {len(points)}")
        return None
    return aerofoils.halves_joined(loops.Loop(points[:upper], lines[:upper]), loops.Loop(points[upper:], lines[upper:]))


def copy_of(loop):
    return loops.Loop(list(loop.points), list(loop.lines))


def aerofoil_of(file, loop, rounding, tolerance, notes):
    """The loop as an aerofoil, or None. Adds what was left out and changed to the notes."""
    if len(loop.points) < aerofoils.LEAST_POINTS:
        return None
    first_line = loop.lines[0]
    loop = copy_of(loop)
    was_closed, repeated = loops.close(file, loop, tolerance)
    if was_closed:
        loop = loops.Loop(loop.points + loop.points[:1], loop.lines + loop.lines[:1])
    whole = len(loop.points)
    loop, overlap = aerofoils.without_crossing(loop, rounding)
    is_cut = len(loop.points) < whole
    loops.close(file, loop, tolerance)
    shape = aerofoils.recognise(loop, rounding)
    if shape is None:
        return None
    note_repeated(notes, repeated)
    if is_cut:
        how = f"cross by {overlap:.2g}" if overlap > 0 else "touch"
        notes.append(f"the sides {how} at the trailing edge, by rounding: both end at their middle")
    if loop.lines[shape.nose] == first_line or first_line not in (loop.lines[0], loop.lines[shape.base or 0]):
        notes.append(f"the points from line {first_line} on start at the nose: they are read from the trailing edge on")
    return shape


def note_repeated(notes, lines):
    if lines:
        notes.append(f"{len(lines)} repeated point{'s are' if len(lines) > 1 else ' is'} left out, line {lines[0]}"
                     + (" the first" if len(lines) > 1 else ""))


def aerofoil_form(file, rows, kind, shapes, notes):
    order = "in two halves from the nose" if kind == "lednicer" else "from the trailing edge around the nose and back"
    points = sum(len(shape.loop.points) for shape in shapes)
    what = "an aerofoil" if len(shapes) == 1 else f"{len(shapes)} aerofoils, each"
    return Form(file, kind, [shape.loop for shape in shapes], shapes, rows.title or kind, rows.rounding,
                [f"{what} {order}, {points} points"] + rows.notes + notes)


def points_form(file, rows, tolerance):
    notes, found = [], [copy_of(loop) for loop in rows.loops]
    repeated = [line for loop in found for line in loops.close(file, loop, tolerance)[1]]
    note_repeated(notes, repeated)
    count = sum(len(loop.points) for loop in found)
    form = f"{len(found)} closed loop{'s' * (len(found) > 1)} through {count} points"
    return Form(file, "points", found, [], rows.title or "points", rows.rounding, [form] + rows.notes + notes)


def requested_aerofoil(file, rows, kind, tolerance):
    """As it is, where the points are not those of an aerofoil: it begins at its trailing edge, which is blunt if its last
    point is another one."""
    loop, notes = without_counts(file, rows, True) if kind == "lednicer" else rows.joined(), []
    shape = aerofoil_of(file, loop, rows.rounding, tolerance, notes)
    if shape is None:
        loop = copy_of(loop)
        was_closed, repeated = loops.close(file, loop, tolerance)
        note_repeated(notes, repeated)
        shape = Aerofoil(loop, None if was_closed else len(loop.points) - 1, None)
    return aerofoil_form(file, rows, kind, [shape], notes)
