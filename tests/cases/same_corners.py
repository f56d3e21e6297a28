#!/usr/bin/python3
"""Tells whether two meshes are the same up to a motion.

    same_corners.py [--mirror] [--rotate DEGREES] [--move X Y] [--start N] A.quad.h5 B.quad.h5 TOLERANCE

A, moved as by tests/data/move_step.py, must have as many quads as B, and their corners must be the same points, one
for one, within TOLERANCE of the diameter. Prints the greatest distance as a share of the diameter."""
import argparse, cmath, math, sys

import h5py, numpy as np

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("--mirror", action="store_true")
parser.add_argument("--rotate", type=float, default=0)
parser.add_argument("--move", type=float, nargs=2, default=(0, 0))
parser.add_argument("--start", type=int, default=0, help="of loops; changes nothing")
parser.add_argument("first")
parser.add_argument("second")
parser.add_argument("tolerance", type=float)
options = parser.parse_args()


def corners(path):
    with h5py.File(path) as mesh:
        order, nodes = int(mesh["order"][()]), mesh["nodes"][()] + mesh["face/origin"][()]
        elems = mesh["elem_nodes"][()].reshape(-1, (order + 1) ** 2)
        used = np.unique(elems[:, [0, order, order * (order + 1), -1]])
        return len(elems), nodes[used, 0] + 1j * nodes[used, 1], float(mesh["face/diameter"][()])


(num_first, first, _), (num_second, second, diameter) = corners(options.first), corners(options.second)
if num_first != num_second or len(first) != len(second):
    sys.exit(f"{num_first} and {num_second} quads")
if options.mirror:
    first = first.conjugate()
first = first * cmath.exp(1j * math.radians(options.rotate)) + complex(*options.move)
distances = np.abs(first[:, None] - second[None, :])
if len(set(distances.argmin(axis=1))) != len(first):
    sys.exit("corners do not correspond one to one")
share = distances.min(axis=1).max() / diameter
print(f"{share:.2g}")
if not share <= options.tolerance:
    sys.exit(f"off by {share:.2g} diameters")
