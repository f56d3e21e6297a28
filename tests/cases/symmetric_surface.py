#!/usr/bin/python3
"""How far the nodes of a mesh in space are from their mirror images.

    symmetric_surface.py A.msh AXIS...

Reflects the nodes at the plane x, y or z (AXIS) = the middle of their range and prints, for each AXIS, the greatest
distance of an image from the nearest node, in diagonals of the box of all nodes."""
import math
import sys


def nodes(path):
    """The lines of three numbers of the section $Nodes."""
    lines = open(path, encoding="ascii").read().split("$Nodes\n")[1].split("$EndNodes")[0].splitlines()
    return [tuple(map(float, line.split())) for line in lines if len(line.split()) == 3]


def greatest_miss(points, axis, diagonal):
    """A grid of cells finds near nodes; an image without any in the neighbouring cells is a cell away at least."""
    middle = (min(p[axis] for p in points) + max(p[axis] for p in points)) / 2
    cell = 1e-3 * diagonal
    grid = {}
    for p in points:
        grid.setdefault(tuple(math.floor(c / cell) for c in p), []).append(p)
    most = 0
    for p in points:
        image = [2 * middle - c if k == axis else c for k, c in enumerate(p)]
        x, y, z = (math.floor(c / cell) for c in image)
        near = (q for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1) for q in grid.get((x + i, y + j, z + k), ()))
        most = max(most, min((math.dist(image, q) for q in near), default=cell))
    return most / diagonal


def main():
    points = nodes(sys.argv[1])
    diagonal = math.dist([min(c) for c in zip(*points)], [max(c) for c in zip(*points)])
    for axis in sys.argv[2:]:
        print(f"{greatest_miss(points, 'xyz'.index(axis), diagonal):.1e}")


if __name__ == "__main__":
    main()
