"""Reads files of points: lines of x and y with blank lines between loops, or the coordinates of an aerofoil in the
format of Selig (over the nose and back) or Lednicer (each side from the nose)."""
import math
import pathlib
import re
import sys

from command_frame import BAD_INPUT, Failure
from outline.loops import Loop

FORMATS = ("auto", "points", "selig", "lednicer")


class PointFile:
    """The lines of a file; lines are numbered from 1."""

    def __init__(self, name, text):
        self.name, self.lines = name, text.splitlines()

    def fault(self, line, message):
        """A failure that names the line; 0: the file as a whole."""
        return Failure(BAD_INPUT, f"{self.name}: line {line}: {message}" if line else f"{self.name}: {message}")

    def content(self, line):
        """Of a line, without its comment."""
        return self.lines[line - 1].split("#")[0].strip()

    def is_blank(self, line):
        """True for a line without even a comment, and behind the last line."""
        return line > len(self.lines) or not self.lines[line - 1].strip()

    def pair(self, line):
        """Two numbers, or None where the line contains something else."""
        content = self.content(line)
        try:
            values = [float(re.sub("[dD]", "e", word)) for word in re.sub("[,;]", " ", content).split()]
        except ValueError:
            return None
        return complex(*values) if len(values) == 2 and "_" not in content else None

    def point(self, line):
        z = self.pair(line)
        if z is None:
            raise self.fault(line, f"expected x and y, found '{self.content(line)[:40]}'")
        if not (math.isfinite(z.real) and math.isfinite(z.imag)):
            raise self.fault(line, f"'{self.content(line)[:40]}' is not finite")
        return z

    def filled_lines(self):
        """The numbers of the lines that contain anything but a comment."""
        return [line for line in range(1, len(self.lines) + 1) if self.content(line)]


def read_point_file(path):
    """The file, or standard input for -; UTF-8 or else Latin-1."""
    if path == "-" and sys.stdin.isatty():
        raise Failure(BAD_INPUT, "standard input is a terminal; name a file")
    try:
        data = sys.stdin.buffer.read() if path == "-" else pathlib.Path(path).read_bytes()
    except OSError as error:
        raise Failure(BAD_INPUT, f"{path}: cannot be read: {error.strerror}") from None
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = data.decode("latin-1")
    return PointFile("standard input" if path == "-" else path, text)


def point_loops(file):
    """The loops of a file of points. Only a blank line ends a loop; a line with a comment does not."""
    loops, lines = [], []
    for line in range(1, len(file.lines) + 2):
        if not file.is_blank(line):
            lines += [line] if file.content(line) else []
        elif lines:
            loops.append(Loop([file.point(k) for k in lines], lines))
            lines = []
    if not loops:
        raise file.fault(0, "there are no points")
    return loops


def is_pair_of_counts(z):
    return z is not None and min(z.real, z.imag) >= 2 and z.real == int(z.real) and z.imag == int(z.imag)


def detect_format(file):
    """By the first lines: points have no title, and Lednicer's format has numbers of points behind its title."""
    lines = file.filled_lines()
    if not lines or file.pair(lines[0]) is not None:
        return "points"
    return "lednicer" if len(lines) > 1 and is_pair_of_counts(file.pair(lines[1])) else "selig"


def aerofoil(file, is_lednicer):
    """(loop, title, nose): one loop from the trailing edge along one side to the nose and back along the other; the
    nose is the number of its point, or None where the format does not tell it."""
    lines, title, nose = file.filled_lines(), "", None
    if file.pair(lines[0]) is None:
        title = file.content(lines[0])
        lines = lines[1:]
    if is_lednicer:
        lines, nose = lednicer_sides(file, lines)
    if not lines:
        raise file.fault(0, "there are no points")
    return Loop([file.point(line) for line in lines], lines), title, nose


def lednicer_sides(file, lines):
    """The lines in the order of Selig, and the position of the nose among them."""
    counts = file.pair(lines[0]) if lines else None
    if not is_pair_of_counts(counts):
        raise file.fault(lines[0] if lines else 0, "expected the numbers of points of the upper and lower side")
    upper, lower = int(counts.real), int(counts.imag)
    if upper + lower != len(lines) - 1:
        raise file.fault(lines[0], f"expected {upper} + {lower} points, found {len(lines) - 1}")
    first, second = lines[1 : 1 + upper], lines[1 + upper :]
    is_shared = file.point(first[0]) == file.point(second[0])
    return first[::-1] + second[is_shared:], upper - 1
