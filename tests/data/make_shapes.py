#!/usr/bin/env python3
"""Writes test shapes as STEP and IGES files into the folder given, by default beside itself: python3 make_shapes.py [FOLDER].
Plain Python; the same bytes every time."""
import cmath
import math
import os
import sys

from iges_text import Iges
from step_text import Step, cubic_through, polygon, rectangle, step_text


def naca0012(sides=48):
    """From the trailing edge under the nose and back above it: clockwise round the aerofoil is a hole's direction."""
    def half_thickness(x):
        return 0.6 * (0.2969 * math.sqrt(x) - 0.1260 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1036 * x**4)

    xs = [(1 + math.cos(math.pi * k / sides)) / 2 for k in range(sides + 1)]
    xs[0], xs[-1] = 1.0, 0.0
    lower = [complex(x, -half_thickness(x)) for x in xs]
    lower[0] = 1 + 0j
    points = lower + [z.conjugate() for z in reversed(lower[:-1])]
    lengths = [abs(b - a) for a, b in zip(lower, lower[1:])]
    parameters = [0.0]
    for length in lengths + lengths[::-1]:
        parameters.append(parameters[-1] + length)
    slope = 0.6 * (0.2969 / 2 - 0.1260 - 2 * 0.3516 + 3 * 0.2843 - 4 * 0.1036)
    start = complex(-1, slope) / abs(complex(-1, slope))
    poles, knots = cubic_through(points, parameters, start, -start.conjugate())
    return [("spline", poles, knots)]


def two_elements():
    """The aerofoil of chord 1 with a flap of chord 0.3 at -20 degrees beneath its tail, 0.035 away."""
    (_, poles, knots), = naca0012()
    turn = 0.3 * cmath.exp(-1j * math.radians(20))
    flap = [0.96 - 0.05j + turn * z for z in poles]
    return [rectangle(-2 - 2j, 4 + 2j), [("spline", poles, knots, "main")], [("spline", flap, knots, "flap")]]


def nautilus(sides=96):
    """The spiral r = 0.8 + 0.4 t / (2 pi), one turn, and the straight step back to its start."""
    parameters = [2 * math.pi * k / sides for k in range(sides + 1)]
    growth = 0.4 / (2 * math.pi)
    points = [(0.8 + growth * t) * cmath.exp(1j * t) for t in parameters]
    points[0], points[-1] = 0.8 + 0j, 1.2 + 0j
    poles, knots = cubic_through(points, parameters, complex(growth, 0.8), complex(growth, 1.2))
    return [("spline", poles, knots), ("line", points[-1], points[0])]


def bow_shock():
    """The flow before a cylinder: a box with half a disc cut out of its right side."""
    corners = [-2 + 2j, -2 - 2j, -2j, -0.5j, 0.5j, 2j]
    edges = [("line", a, b) for a, b in zip(corners, corners[1:] + corners[:1])]
    edges[3] = ("arc", 0j, 0.5, -0.5j, 0.5j, -1)
    return edges


def shapes():
    octagon = [cmath.exp(1j * math.pi * (2 * k + 1) / 8) for k in range(8)]
    return {
        "naca0012": [rectangle(-1.5 - 1.5j, 2.5 + 1.5j), naca0012()],
        "two_elements": two_elements(),
        "geometry_2": [nautilus()],
        "octagon": [polygon(octagon)],
        "plate_chamfered_4": [polygon([0.5, 3.5, 4 + 0.5j, 4 + 2.5j, 3.5 + 3j, 0.5 + 3j, 2.5j, 0.5j])],
        "bow_shock": [bow_shock()],
        "duct": [rectangle(0j, 3 + 1j)],
        "thin_ellipse": [[("circle", 0j, 3, 1, "far")], [("ellipse", 0j, 1, 0.15, -1, "body")]],
        "cavity_ramp": [polygon([-2, 0, -1j, 2 - 1j, 3, 5, 5 + 1j, -2 + 1j])],
        "filleted_plate": [polygon([-2, 2, 2 + 1j, 1 + 1j, 1 + 2j, -1 + 2j, -1 + 1j, -2 + 1j],
                                   [0.05, 0.05, 0.05, 0.04, 0.05, 0.05, 0.04, 0.05])],
    }


def labels():
    """Edges of a channel with all ways of naming them: name, layer (of the edge, its curve, its styled item), colour."""
    step = Step()
    corners = [0, 2, 2 + 1j, 1j]
    loop = [("line", a, b) for a, b in zip(map(complex, corners), map(complex, corners[1:] + corners[:1]))]
    loop[0] += ("  Zuflu\\X2\\00DF\\X0\\ ",)
    face = step.face([loop, [("circle", 1 + 0.5j, 0.2, -1)]])
    bottom, right, top, left, circle = step.edges
    step.layer("walls", [bottom, step.curves[2]])
    styled = step.coloured(right, (0, 1, 0))
    step.layer("outlet", [styled])
    step.coloured(bottom, (0, 1, 0))
    step.coloured(left, (1, 0.5, 0))
    plain = step.coloured(circle, "red")
    step.coloured(circle, "blue", over=plain)
    step.layer("part", [face, circle])
    step.product("labels", face)
    return step.text("labels")


def iges_labels():
    """The channel again, in IGES, with a name property, levels, a colour by number and one of its own."""
    iges = Iges()
    plane = iges.add(108, 0.0, 0.0, 1.0, 0.0, 0, 0.0, 0.0, 0.0, 0.0)
    name = iges.add(406, 1, "the wall", form=15)
    sides = [iges.add(110, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0, 1, name, level=5),
             iges.add(110, 2.0, 0.0, 0.0, 2.0, 1.0, 0.0, level=5),
             iges.add(110, 2.0, 1.0, 0.0, 0.0, 1.0, 0.0, colour=2),
             iges.add(110, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, level=1)]
    outline = iges.add(142, 0, plane, 0, iges.add(102, 4, *sides), 2)
    orange = iges.add(314, 100.0, 50.0, 0.0)
    circle = iges.add(100, 0.0, 1.0, 0.5, 1.2, 0.5, 1.2, 0.5, colour=-orange)
    hole = iges.add(142, 0, plane, 0, circle, 2)
    iges.add(144, plane, 1, 1, outline, hole, level=1)
    return iges.text("labels")


def tilted():
    """The upper half of the unit disc in a plane across the axes of space."""
    frame = (10, -20, 30), (1 / 3, 2 / 3, 2 / 3), (2 / 3, 1 / 3, -2 / 3)
    step = Step(frame)
    face = step.face([[("line", -1 + 0j, 1 + 0j, "axis"), ("arc", 0j, 1, 1 + 0j, -1 + 0j, 1, "arc")]])
    step.product("tilted_half_disc", face)
    return step.text("tilted_half_disc")


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))
    for name, loops in shapes().items():
        with open(os.path.join(folder, name + ".step"), "w", encoding="ascii") as file:
            file.write(step_text(name, loops))
    others = {"labels.step": labels(), "labels.iges": iges_labels(), "tilted_half_disc.step": tilted()}
    for name, text in others.items():
        with open(os.path.join(folder, name), "w", encoding="ascii") as file:
            file.write(text)


if __name__ == "__main__":
    main()
