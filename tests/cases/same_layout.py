#!/usr/bin/python3
"""Tells whether two layouts are the same up to a motion.

    same_layout.py [--mirror] [--rotate DEGREES] [--scale S] [--move X Y] A.sep.json B.sep.json TOLERANCE

The graph of A, moved as by tests/data/move_step.py, must be that of B: nodes one for one by position, kind and valence,
arcs by their end nodes, and nodes and arcs within TOLERANCE of B's diameter. Prints the greatest distance as a share of
the diameter, and where it is."""
import argparse, sys

sys.dont_write_bytecode = True
import layout_graph

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("--mirror", action="store_true")
parser.add_argument("--rotate", type=float, default=0)
parser.add_argument("--scale", type=float, default=1)
parser.add_argument("--move", type=float, nargs=2, default=(0, 0))
parser.add_argument("first", type=layout_graph.Graph)
parser.add_argument("second", type=layout_graph.Graph)
parser.add_argument("tolerance", type=float)
options = parser.parse_args()

motion = layout_graph.motion(options.mirror, options.rotate, options.scale, options.move)
try:
    distance, where = layout_graph.apart(options.first, options.second, motion)
except layout_graph.Differs as difference:
    sys.exit(f"not the same graph; {difference}")
share = distance / options.second.diameter
print(f"{share:.2g}, {where}")
if not share <= options.tolerance:
    sys.exit(f"off by {share:.2g} diameters, {where}")
