"""The rows of a file of points: what stands above them, which columns are x and y, and where one loop ends."""
import re
from dataclasses import dataclass, field

from outline.loops import Loop
from outline.point_files import numbers_in

SEPARATOR = 999.0  # in both columns: the end of an element, in files of several aerofoils
NEAR_ORIGIN = 500.0  # coordinates of all other points, where such a row is a separator and no point
DIGITS = 15  # decimals of numbers that are not rounded


@dataclass
class Rows:
    title: str
    loops: list  # of points and lines, without names; a blank line or a separator ends one
    rounding: float  # the greatest rounding error of a coordinate: half a unit of the last decimal
    notes: list = field(default_factory=list)  # sentences on what was read in a special way

    def joined(self):
        """The rows of all loops in their order."""
        return Loop([z for loop in self.loops for z in loop.points], [line for loop in self.loops for line in loop.lines])


def read_rows(file):
    """The loops of a file. A comment does not end a loop. Throws Failure with the line that is no point."""
    lines, notes = file.filled_lines(), []
    heading, lines = heading_of(file, lines)
    if heading:
        lines_of = f"line {heading[0]} is" if len(heading) == 1 else f"lines {heading[0]} to {heading[-1]} are"
        notes.append(f"{lines_of} a heading: '{file.content(heading[0])[:40]}'")
    if len(lines) > 1 and len(file.numbers(lines[0]) or ()) == 4 and len(file.numbers(lines[1]) or ()) == 2:
        notes.append(f"line {lines[0]} holds four numbers, the region of a grid: it is left out")
        lines = lines[1:]
    if not lines:
        raise file.fault(0, "there are no points")
    columns, width = columns_of(file, heading, lines, notes)
    points = {line: file.point(line, columns, width) for line in lines}
    ends = separators(points, notes)
    loops = divided(file, points, ends)
    if not loops:
        raise file.fault(0, "there are no points")
    title = file.content(heading[0]) if heading and columns_named(file, heading) is None else ""
    return Rows(title, loops, rounding_of(file, points, columns), notes)


def heading_of(file, lines):
    """(lines above the points, the others). A line that begins with a number is above them only as the first one."""
    for k, line in enumerate(lines):
        words = file.words(line)
        if len(file.numbers(line) or ()) > 1 or k > 0 and numbers_in(words[:1]):
            return lines[:k], lines[k:]
    return lines, []


def columns_named(file, heading):
    """The columns that a heading calls x and y, in the order of the heading, and how many there are; else None."""
    words = re.sub(r"\(.*?\)|\[.*?\]|[\"',;]", " ", file.content(heading[-1])) if heading else ""
    names = words.lower().split()
    return (names.index("x"), names.index("y"), len(names)) if {"x", "y"} <= set(names) else None


def columns_of(file, heading, lines, notes):
    """((column of x, column of y), number of columns). A third column of zeros is left out."""
    named = columns_named(file, heading)
    widths = {len(file.numbers(line) or ()) for line in lines}
    if named and widths == {named[2]}:
        if named[2] > 2:
            notes.append(f"columns {named[0] + 1} and {named[1] + 1} are x and y, as the heading names them")
        return named[:2], named[2]
    if widths == {3}:
        other = next((line for line in lines if file.numbers(line)[2] != 0), None)
        if other is not None:
            raise file.fault(other, f"expected x and y, found '{file.content(other)[:40]}': its third number is not 0")
        notes.append("the third column, zeros, is left out")
        return (0, 1), 3
    return (0, 1), 2


def separators(points, notes):
    """The lines of rows that separate loops."""
    found = {line for line, z in points.items() if z == complex(SEPARATOR, SEPARATOR)}
    others = [z for line, z in points.items() if line not in found]
    if not found or any(max(abs(z.real), abs(z.imag)) > NEAR_ORIGIN for z in others):
        return set()
    notes.append(f"line {min(found)}, 999 in both columns, separates loops")
    return found


def divided(file, points, ends):
    """Loops of the points; blank lines and the lines `ends` are between them."""
    loops, lines = [], []
    last = max(points)
    for line in range(min(points), last + 2):
        if line in points and line not in ends:
            lines.append(line)
        elif lines and (line in ends or file.is_blank(line) or line > last):
            loops.append(Loop([points[k] for k in lines], lines))
            lines = []
    return loops


def rounding_of(file, points, columns):
    """Half a unit of the last decimal of any coordinate."""
    most = 0
    for line in points:
        words = file.words(line)
        for column in columns:
            number = re.fullmatch(r"[-+]?\d*\.?(\d*)(?:[eEdD]([-+]?\d+))?", words[column])
            decimals = len(number[1]) - int(number[2] or 0) if number else DIGITS
            if decimals > most:
                most = decimals
    return 0.5 * 10.0**-most if most < DIGITS else 0.0


def point_loops(file):
    """The loops of a file that is known to hold points."""
    return read_rows(file).loops
