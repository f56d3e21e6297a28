"""The curves of SVG path data (SVG 2, chapter 9), in user units with y downwards."""
import cmath
import math
import re

from drawing.curves import Segment, bezier, ellipse

NUMBER = re.compile(r"[\s,]*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)")
FLAG = re.compile(r"[\s,]*([01])")
COMMAND = re.compile(r"[\s,]*([MmZzLlHhVvCcSsQqTtAa])")


class PathError(ValueError):
    """The data cannot be read; the message says where."""


class PathReader:
    """Reads commands one after another; `found` are the curves."""

    def __init__(self, data):
        self.data, self.position, self.found = data, 0, []
        self.start = self.here = 0j  # of the sub-path, and where the pen is
        self.handle = None  # (degree, last control point) of the Bezier curve before, if the last command drew one

    def match(self, pattern):
        found = pattern.match(self.data, self.position)
        if found:
            self.position = found.end()
        return found and found[1]

    def expect(self, pattern, what):
        found = self.match(pattern)
        if found is None:
            near = self.data[self.position : self.position + 20].strip()
            raise PathError(f"{what} expected" + (f" before '{near}'" if near else " at its end"))
        return float(found)

    def number(self):
        return self.expect(NUMBER, "a number")

    def point(self, is_relative):
        x = self.number()
        return complex(x, self.number()) + (self.here if is_relative else 0)

    def read(self):
        if self.data.strip() in ("", "none"):
            return []
        command = self.match(COMMAND)
        if command not in ("M", "m"):
            raise PathError("it does not begin with M or m")
        while command:
            self.run(command)
            command = self.match(COMMAND)
        if self.data[self.position :].strip(" \t\r\n,"):
            raise PathError(f"a command expected before '{self.data[self.position:].strip()[:20]}'")
        return self.found

    def run(self, command):
        """A command with all its arguments; points behind the first of M are those of L."""
        draw = getattr(self, "draw_" + command.upper())
        if command in "Zz":
            return draw(False)
        draw(command.islower())
        while NUMBER.match(self.data, self.position):
            (self.draw_L if command in "Mm" else draw)(command.islower())

    def add(self, curve, end, handle=None):
        if curve is not None:
            self.found.append(curve)
        self.here, self.handle = end, handle

    def add_line(self, end):
        self.add(Segment(self.here, end) if end != self.here else None, end)

    def draw_M(self, is_relative):
        self.add(None, self.point(is_relative))
        self.start = self.here

    def draw_Z(self, _):
        self.add_line(self.start)

    def draw_L(self, is_relative):
        self.add_line(self.point(is_relative))

    def draw_H(self, is_relative):
        self.add_line(complex(self.number() + (self.here.real if is_relative else 0), self.here.imag))

    def draw_V(self, is_relative):
        self.add_line(complex(self.here.real, self.number() + (self.here.imag if is_relative else 0)))

    def add_bezier(self, *poles):
        curve = bezier([self.here, *poles]) if any(z != self.here for z in poles) else None
        self.add(curve, poles[-1], (len(poles), poles[-2]))

    def mirrored_handle(self, degree):
        return 2 * self.here - self.handle[1] if self.handle and self.handle[0] == degree else self.here

    def draw_C(self, is_relative):
        self.add_bezier(self.point(is_relative), self.point(is_relative), self.point(is_relative))

    def draw_S(self, is_relative):
        self.add_bezier(self.mirrored_handle(3), self.point(is_relative), self.point(is_relative))

    def draw_Q(self, is_relative):
        self.add_bezier(self.point(is_relative), self.point(is_relative))

    def draw_T(self, is_relative):
        self.add_bezier(self.mirrored_handle(2), self.point(is_relative))

    def draw_A(self, is_relative):
        rx, ry, turn = abs(self.number()), abs(self.number()), math.radians(self.number())
        is_large, is_left = (self.expect(FLAG, "a flag, 0 or 1,") == 1 for _ in range(2))
        end = self.point(is_relative)
        if end == self.here or rx == 0 or ry == 0:
            return self.add_line(end)
        self.add(arc(self.here, end, rx, ry, turn, is_large, is_left), end)


def arc(start, end, rx, ry, turn, is_large, is_increasing):
    """Of the ellipse with half axes rx, ry, the first turned by `turn`, through start and end; ellipses that are too
    small grow (SVG 2, appendix B.2)."""
    def on_unit_circle(z):
        z *= cmath.exp(-1j * turn)
        return complex(z.real / rx, z.imag / ry)

    half = on_unit_circle((end - start) / 2)
    growth = max(abs(half), 1.0)
    rx, ry, half = rx * growth, ry * growth, half / growth
    side = 1j if is_large != is_increasing else -1j
    to_centre = side * half / abs(half) * math.sqrt(max(1 - abs(half) ** 2, 0.0))
    axis = cmath.exp(1j * turn)
    centre = (start + end) / 2 + axis * complex(rx * to_centre.real, ry * to_centre.imag)
    first, last = cmath.phase(-half - to_centre), cmath.phase(half - to_centre)
    angle = (last - first if is_increasing else first - last) % (2 * math.pi)
    sign = 1 if is_increasing else -1
    return ellipse(centre, rx * axis, sign * 1j * ry * axis, sign * first, sign * first + angle)


def path_curves(data):
    """Throws PathError."""
    return PathReader(data).read()
