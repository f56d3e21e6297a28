#!/usr/bin/python3
"""Tells whether the blocks of two meshes on a surface are the same.

    same_surface_blocks.py A.quad.h5 B.quad.h5 TOLERANCE

Both must have as many quads. Corners of blocks in A must be those in B, one for one, and blocks have the same four
corners. Prints the greatest distance of two of them in space, in diagonals of the box of all nodes of B. Ends with 1
where the numbers of quads differ, blocks do not correspond, or a corner is farther than the tolerance."""
import collections
import math
import sys

import h5py
import numpy


class Blocks:
    def __init__(self, path):
        with h5py.File(path) as file:
            n = int(file["order"][()])
            self.nodes = file["space_nodes"][()]
            elems = file["elem_nodes"][()].reshape(-1, (n + 1) ** 2)
            blocks = file["elem_block"][()]
        self.num_quads = len(elems)
        self.diagonal = numpy.linalg.norm(numpy.ptp(self.nodes, axis=0))
        # A corner of a block is the corner of one of its elements, a node of its sides that of two, others of four.
        counts = collections.Counter(
            (block, node) for block, elem in zip(blocks, elems)
            for node in (elem[0], elem[n], elem[(n + 1) ** 2 - 1], elem[n * (n + 1)]))
        self.corners = collections.defaultdict(set)
        for (block, node), count in counts.items():
            if count == 1:
                self.corners[block].add(node)


def main():
    first, second = Blocks(sys.argv[1]), Blocks(sys.argv[2])
    of_first, of_second = (sorted(set().union(*blocks.corners.values())) for blocks in (first, second))
    partner = {a: min(of_second, key=lambda b, a=a: math.dist(first.nodes[a], second.nodes[b])) for a in of_first}
    distance, worst = max((math.dist(first.nodes[a], second.nodes[b]) / second.diagonal, a) for a, b in partner.items())
    print(f"{distance:.1e}")
    if first.num_quads != second.num_quads:
        sys.exit(f"{first.num_quads} quads in place of {second.num_quads}")
    if sorted(partner.values()) != of_second:
        sys.exit("corners of blocks do not correspond")
    moved = collections.Counter(frozenset(partner[a] for a in corners) for corners in first.corners.values())
    if moved != collections.Counter(map(frozenset, second.corners.values())):
        sys.exit("blocks do not correspond")
    if not distance <= float(sys.argv[3]):
        sys.exit(f"the corner at {first.nodes[worst]} is off by {distance:.1e}")


if __name__ == "__main__":
    main()
