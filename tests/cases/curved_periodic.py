#!/usr/bin/env python3
"""Checks the periodic sides of a quad mesh on a curved face, by a motion that the caller knows.

    curved_periodic.py x.quad.h5 FROM TO MATRIX SHIFT

MATRIX, nine numbers row by row, and SHIFT, three, with commas, are expressions of Python (math is there). Fails unless
the sides have as many nodes, blocks end at the same ones, and those of TO are the images of those of FROM within 1e-12 diameters. Prints the number
of nodes and the distance.
"""
import math
import sys

import h5py
import numpy as np


def side(file, name):
    """Nodes along the curves of a name, in the order of the loop, each once, and where blocks end between elements."""
    names = [n.decode() for n in file["face/curve_names"][:]]
    curve, elem, start = (file[f"boundary_edges/{k}"][:] for k in ("curve", "elem", "side"))
    order = int(file["order"][()])
    nodes = file["elem_nodes"][:].reshape(-1, order + 1, order + 1)  # [elem, xi2, xi1]
    sides = [lambda e: e[0, :], lambda e: e[:, -1], lambda e: e[-1, ::-1], lambda e: e[::-1, 0]]
    result, blocks = [], []
    for c in (i for i, n in enumerate(names) if n == name):
        for e in np.flatnonzero(curve == c):
            along = list(sides[start[e]](nodes[elem[e]]))
            result += along[1:] if result and result[-1] == along[0] else along
            blocks.append(file["elem_block"][int(elem[e])])
    return result, [x != y for x, y in zip(blocks[:-1], blocks[1:])]


def main():
    path, first, second, matrix, shift = sys.argv[1:]
    matrix, shift = np.reshape(eval(f"[{matrix}]", {"math": math}), (3, 3)), eval(f"[{shift}]", {"math": math})
    with h5py.File(path) as file:
        space = file["space_nodes"][:]
        (a, a_ends), (b, b_ends) = side(file, first), side(file, second)
    b, b_ends = b[::-1], b_ends[::-1]
    assert len(a) == len(b) > 2, f"{len(a)} nodes on {first}, {len(b)} on {second}"
    assert a_ends == b_ends, f"blocks end at {a_ends} and {b_ends}"
    extent = np.linalg.norm(space.max(axis=0) - space.min(axis=0))
    off = np.abs(space[a] @ matrix.T + shift - space[b]).max() / extent
    assert off <= 1e-12, f"nodes are {off:.2g} diameters away from the images"
    print(f"{len(a)} nodes, {off:.1e}")


main()
