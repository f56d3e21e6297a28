#!/usr/bin/python3
"""Tells whether two files of irregular nodes are the same up to a motion.

    same_nodes.py [--mirror] [--rotate DEGREES] [--scale S] [--move X Y] [--congruent] A.crit.json B.crit.json TOLERANCE

Nodes, corners and boundary nodes of A, moved as by tests/data/move_step.py, must be those of B: one for one, with their
valences, within TOLERANCE of A's extent (times S). With --congruent the nodes need only have the same distances among
each other and to their centre: what is left of it on a shape with more symmetries than its nodes, a disc. Prints the
greatest distance as a share of the extent."""
import argparse, itertools, json, math, sys

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("--mirror", action="store_true")
parser.add_argument("--rotate", type=float, default=0)
parser.add_argument("--scale", type=float, default=1)
parser.add_argument("--move", type=float, nargs=2, default=(0, 0))
parser.add_argument("--congruent", action="store_true")
parser.add_argument("--extent", type=float, help="the face's diameter (default: the greatest distance of listed points)")
parser.add_argument("first")
parser.add_argument("second")
parser.add_argument("tolerance", type=float)
options = parser.parse_args()


def points(path):
    content = json.load(open(path))
    origin = content["origin"]
    return [(kind, p["valence"], p["position"][0] + origin[0], p["position"][1] + origin[1])
            for kind in ("critical_points", "corners", "boundary_nodes") for p in content[kind]
            if kind != "corners" or p["valence"] != 2 or p["source"] != "angle"]


def moved(point):
    kind, valence, x, y = point
    y = -y if options.mirror else y
    c, s = math.cos(math.radians(options.rotate)), math.sin(math.radians(options.rotate))
    return (kind, valence, options.scale * (c * x - s * y) + options.move[0],
            options.scale * (s * x + c * y) + options.move[1])


def distance(a, b):
    return math.hypot(a[2] - b[2], a[3] - b[3])


first, second = points(options.first), points(options.second)
extent = options.extent or max((distance(a, b) for a, b in itertools.combinations(first, 2)), default=1.0)
extent *= options.scale
first = [moved(p) for p in first]
if sorted(p[:2] for p in first) != sorted(p[:2] for p in second):
    sys.exit(f"the nodes differ: {sorted(p[:2] for p in first)} and {sorted(p[:2] for p in second)}")
if options.congruent:
    lengths = [sorted(distance(a, b) for a, b in itertools.combinations(all_points, 2)) for all_points in (first, second)]
    worst = max((abs(a - b) for a, b in zip(*lengths)), default=0)
else:
    worst = 0
    for a in first:
        same = [b for b in second if b[:2] == a[:2]]
        nearest = min(same, key=lambda b: distance(a, b))
        second.remove(nearest)
        worst = max(worst, distance(a, nearest))
print(f"{worst / extent:.2g}")
if not worst <= options.tolerance * extent:
    sys.exit(f"off by {worst / extent:.2g} of the extent")
