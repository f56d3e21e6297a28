"""Files of points: their lines, and the numbers in them."""
import math
import re

from command_frame import BAD_INPUT, Failure, read_bytes

FORMATS = ("auto", "points", "selig", "lednicer")


class PointFile:
    """The lines of a file; lines are numbered from 1."""

    def __init__(self, name, text, data=b""):
        self.name, self.lines, self.data = name, text.splitlines(), data
        self._numbers = {}  # of the lines that were asked for

    def fault(self, line, message):
        """A failure that names the line; 0: the file as a whole."""
        return Failure(BAD_INPUT, f"{self.name}: line {line}: {message}" if line else f"{self.name}: {message}")

    def content(self, line):
        """Of a line, without its comment."""
        return self.lines[line - 1].split("#")[0].strip()

    def words(self, line):
        return re.sub("[,;]", " ", self.content(line)).split()

    def is_blank(self, line):
        """True for a line without even a comment, and behind the last line."""
        return line > len(self.lines) or not self.lines[line - 1].strip()

    def numbers(self, line):
        """The numbers of a line, or None where it contains something else or nothing."""
        if line not in self._numbers:
            self._numbers[line] = numbers_in(self.words(line))
        return self._numbers[line]

    def point(self, line, columns=(0, 1), width=2):
        """The point of a line of so many numbers, x and y being those of the two columns."""
        values = self.numbers(line)
        if values is None or len(values) != width:
            raise self.fault(line, f"expected x and y, found '{self.content(line)[:40]}'")
        z = complex(values[columns[0]], values[columns[1]])
        if not (math.isfinite(z.real) and math.isfinite(z.imag)):
            raise self.fault(line, f"'{self.content(line)[:40]}' is not finite")
        return z

    def filled_lines(self):
        """The numbers of the lines that contain anything but a comment."""
        return [line for line in range(1, len(self.lines) + 1) if self.content(line)]


def numbers_in(words):
    """Also with exponents of Fortran, 1.5D0; None if a word is no number, or there is none."""
    try:
        values = [float(word.replace("D", "e").replace("d", "e")) for word in words]
    except ValueError:
        return None
    return values if values and not any("_" in word for word in words) else None


def is_cad_file(data):
    """STEP, BREP or IGES: an S in column 73 of the first line."""
    return data.lstrip()[:12] == b"ISO-10303-21" or b"CASCADE Topology V" in data[:200] or data[72:80] == b"S      1"


def read_point_file(path):
    """The file, or standard input for -; UTF-8 or else Latin-1."""
    data = read_bytes(path)
    if is_cad_file(data):
        raise Failure(BAD_INPUT, f"{path}: a CAD file: --farfield and the other options of points do not apply: draw the "
                                 "region up to the far field in the CAD program, and leave them out")
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = data.decode("latin-1")
    return PointFile("standard input" if path == "-" else path, text, data)
