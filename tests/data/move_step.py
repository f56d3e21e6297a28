#!/usr/bin/python3
"""Writes a planar STEP file again after a motion, to hold the tools to their symmetries.

    move_step.py [--mirror] [--rotate DEGREES] [--scale S] [--move X Y] [--start N] IN.step OUT.step

Mirrored in the x-axis first, then turned about the origin, scaled, moved. Loops begin with their edge N, from 0. The
file's faces lie in z = const, in the entities that this project's shapes use: points, directions, placements, circles,
ellipses, splines, vectors."""
import argparse, math, re

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("--mirror", action="store_true")
parser.add_argument("--rotate", type=float, default=0)
parser.add_argument("--scale", type=float, default=1)
parser.add_argument("--move", type=float, nargs=2, default=(0, 0))
parser.add_argument("--start", type=int, default=0)
parser.add_argument("source")
parser.add_argument("target")
options = parser.parse_args()
cosine, sine = math.cos(math.radians(options.rotate)), math.sin(math.radians(options.rotate))


def turned(x, y):
    y = -y if options.mirror else y
    return cosine * x - sine * y, sine * x + cosine * y


def numbers(text):
    return [float(number) for number in text.split(",")]


def listed(values):
    return ",".join(f"{value:.17E}" for value in values)


def point(match):
    values = numbers(match.group(3))
    if match.group(2) in frame_parts:
        return match.group(0)
    if len(values) == 3:
        x, y = turned(values[0], values[1])
        values = [options.scale * x + options.move[0], options.scale * y + options.move[1], options.scale * values[2]]
    else:  # in the plane of the face, whose frame moves along
        values = [options.scale * value for value in values]
    return match.group(1) + listed(values) + "))"


def direction(match):
    values = numbers(match.group(3))
    if match.group(2) in frame_parts:
        return match.group(0)
    if len(values) == 3:
        x, y = turned(values[0], values[1])
        # A mirrored circle's placement stays right-handed with its axis turned round; the face still looks upwards.
        is_turned = options.mirror and match.group(2) in circle_axes
        values = [x, y, -values[2] if is_turned else values[2]]
    return match.group(1) + listed(values) + "))"


def radii(match):
    return match.group(1) + listed(options.scale * value for value in numbers(match.group(2))) + ")"


def begun_later(match):
    edges = match.group(2).split(",")
    start = options.start % len(edges)
    return match.group(1) + ",".join(edges[start:] + edges[:start]) + "))"


def other_sense(match):
    return match.group(1) + {".T.": ".F.", ".F.": ".T."}[match.group(2)] + ")"


text = re.sub(r"\n\s+", "", open(options.source).read())
# Curves in the plane's own coordinates are left out: a mirrored circle has none.
space_curves = dict(re.findall(r"(#\d+) = SURFACE_CURVE\('[^']*',(#\d+),", text))
text = re.sub(r"(EDGE_CURVE\('[^']*',#\d+,#\d+,)(#\d+)",
              lambda match: match.group(1) + space_curves.get(match.group(2), match.group(2)), text)
placements = re.findall(r"(#\d+) = AXIS2_PLACEMENT_3D\('[^']*',(#\d+),(#\d+),(#\d+)\)", text)
planes, circles = (set(re.findall(name + r"\('[^']*',(#\d+)", text)) for name in ("PLANE", "(?:CIRCLE|ELLIPSE)"))
circle_axes = {axis for placement, _, axis, _ in placements if placement in circles}
frame_parts = {part for placement, *parts in placements if placement not in planes | circles for part in parts}
text = re.sub(r"((#\d+) = CARTESIAN_POINT\('[^']*',\()([^)]*)\)\)", point, text)
text = re.sub(r"((#\d+) = DIRECTION\('[^']*',\()([^)]*)\)\)", direction, text)
text = re.sub(r"((?:CIRCLE|ELLIPSE)\('[^']*',#\d+,)([^)]*)\)", radii, text)
text = re.sub(r"(UNCERTAINTY_MEASURE_WITH_UNIT\(LENGTH_MEASURE\()([^)]*)\)", radii, text)
text = re.sub(r"(EDGE_LOOP\('[^']*',\()([^)]*)\)\)", begun_later, text)
if options.mirror:  # the loops run the other way now
    text = re.sub(r"(FACE_(?:OUTER_)?BOUND\('[^']*',#\d+,)(\.[TF]\.)\)", other_sense, text)
open(options.target, "w").write(text)
