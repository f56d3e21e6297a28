#!/usr/bin/env python3
"""Writes the inputs of pipelines/tutorial.md into the folder given, by default pipelines/examples. Plain Python;
the same bytes every time. Lengths in STEP files are millimetres."""
import math
import pathlib
import sys

from step_text import Step


def channel():
    """2.2 m x 0.41 m with a cylinder of diameter 0.1 m at (0.2 m, 0.2 m), below the middle."""
    a, b, c, d = 0j, 2200 + 0j, 2200 + 410j, 410j
    return [[("line", a, b, "walls"), ("line", b, c, "outlet"), ("line", c, d, "walls"), ("line", d, a, "inlet")],
            [("circle", 200 + 200j, 50, -1, "cylinder")]]


def pipe():
    """The cross section of a layer around a pipe that does not lie in its middle: radii 100 and 40, 30 apart."""
    return [[("circle", 0j, 100, 1, "outside")], [("circle", 30 + 0j, 40, -1, "pipe")]]


def aerofoil(sides=60):
    """NACA 0012 with a sharp trailing edge as a file of points in Selig's format: over the upper side to the nose, and
    back below."""
    def half_thickness(x):
        return 0.6 * (0.2969 * math.sqrt(x) - 0.1260 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1036 * x**4)

    xs = [(1 + math.cos(math.pi * k / sides)) / 2 for k in range(sides + 1)]
    upper = [(x, half_thickness(x)) for x in xs]
    upper[0], upper[-1] = (1.0, 0.0), (0.0, 0.0)
    points = upper + [(x, -y) for x, y in reversed(upper[:-1])]
    return "NACA 0012\n" + "".join(f"{x:.10f} {y + 0.0:.10f}\n" for x, y in points)


def step_of(name, loops):
    step = Step()
    step.product(name, step.face(loops))
    return step.text(name)


def main():
    here = pathlib.Path(__file__).resolve().parent
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else here.parent.parent / "pipelines" / "examples"
    for shape in (channel, pipe):
        name = shape.__name__
        (folder / f"{name}.step").write_text(step_of(name, shape()), encoding="ascii")
    (folder / "aerofoil.dat").write_text(aerofoil(), encoding="ascii")


if __name__ == "__main__":
    main()
