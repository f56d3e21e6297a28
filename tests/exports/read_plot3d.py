#!/usr/bin/env python3
"""Reads PLOT3D grids and their neutral map by a parser that shares nothing with the writer, and compares them to the
stage file.

usage: read_plot3d x.xyz x.quad.h5

Prints "grids N", or what differs, and ends with 1 then. Checked are: points of connected sides are equal to the last
bit, each part of each side has one boundary or one neighbour, the cells are those between the nodes of the elements, and
boundaries have their names."""
import sys
from pathlib import Path

import stage_mesh
from element_mesh import real_names, side_indices
from linear_mesh import require_mesh


def grids_of(path):
    words = iter(Path(path).read_text(encoding="ascii").split())
    sizes = [tuple(int(next(words)) for _ in range(3)) for _ in range(int(next(words)))]
    grids = []
    for ni, nj, nk in sizes:
        assert nk == 1
        x, y, z = ([float(next(words)) for _ in range(ni * nj)] for _ in range(3))
        grids.append({(k % ni + 1, k // ni + 1): p for k, p in enumerate(zip(x, y, z))})
    assert next(words, None) is None, "something follows"
    return sizes, grids


def map_of(path, sizes):
    lines = [line.split() for line in Path(path).read_text(encoding="ascii").splitlines() if not line.startswith("#")]
    count = int(lines[0][0])
    assert [tuple(map(int, row)) for row in lines[1:count + 1]] == [(g, *size) for g, size in enumerate(sizes, 1)]
    return lines[count + 1:]


def side_points(numbers, sizes):
    """Grid and points (i, j) of "B F S1 E1 S2 E2", in their order."""
    grid, face, s1, e1, s2, e2 = map(int, numbers)
    (begin, end), flat = ((s1, e1), (s2, e2)) if face in (3, 4) else ((s2, e2), (s1, e1))
    assert flat == (1, 1) and face in (3, 4, 5, 6)
    step = 1 if end > begin else -1
    fixed = {3: 1, 4: sizes[grid - 1][0], 5: 1, 6: sizes[grid - 1][1]}[face]
    along = range(begin, end + step, step)
    return grid - 1, [(fixed, k) if face in (3, 4) else (k, fixed) for k in along]


def sides_left(sizes):
    """All edges of cells along sides: (grid, two points)."""
    left = set()
    for g, (ni, nj, _) in enumerate(sizes):
        for j in (1, nj):
            left |= {(g, frozenset(((i, j), (i + 1, j)))) for i in range(1, ni)}
        for i in (1, ni):
            left |= {(g, frozenset(((i, j), (i, j + 1)))) for j in range(1, nj)}
    return left


def main(path, stage):
    sizes, grids = grids_of(path)
    left, names, edges = sides_left(sizes), real_names(path), {}

    def take(grid, points):
        for pair in zip(points, points[1:]):
            left.remove((grid, frozenset(pair)))

    for word, *numbers in map_of(str(Path(path).with_suffix(".nmf")), sizes):
        grid, points = side_points(numbers[:6], sizes)
        take(grid, points)
        if word != "ONE_TO_ONE":
            assert len(numbers) == 6
            for a, b in zip(points, points[1:]):
                edges[frozenset((grids[grid][a], grids[grid][b]))] = names.get(word, word)
            continue
        donor, others = side_points(numbers[6:12], sizes)
        take(donor, others)
        assert [grids[grid][p] for p in points] == [grids[donor][p] for p in others], "connected points differ"
        swap = (int(numbers[1]) in (3, 4)) != (int(numbers[7]) in (3, 4))
        assert numbers[12:] == ["TRUE" if swap else "FALSE"]
    assert not left, f"{len(left)} parts of sides have no line"
    compare(sizes, grids, edges, stage_mesh.read(stage))
    print(f"grids {len(grids)}")


def compare(sizes, grids, edges, wanted):
    number, points, quads = {}, [], []
    for (ni, nj, _), grid in zip(sizes, grids):
        for j in range(1, nj):
            for i in range(1, ni):
                quad = []
                for at in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                    if grid[at] not in number:
                        number[grid[at]] = len(points)
                        points.append(grid[at])
                    quad.append(number[grid[at]])
                quads.append(quad)
    outside = {}
    for quad in quads:
        for a, b in zip(quad, quad[1:] + quad[:1]):
            if frozenset((points[a], points[b])) in edges:
                outside[a, b] = edges[frozenset((points[a], points[b]))]
    require_mesh(points, quads, outside)
    n, width = wanted.order, wanted.order + 1
    cells = {frozenset(element[k] for k in (j * width + i, j * width + i + 1, (j + 1) * width + i, (j + 1) * width + i + 1))
             for element in wanted.elements for j in range(n) for i in range(n)}
    assert cells == {frozenset(points[p] for p in quad) for quad in quads}, "the cells are others"
    named = {}
    for (e, side), name in wanted.boundaries.items():
        line = [wanted.elements[e][k] for k in side_indices(n, side)]
        named.update({frozenset(pair): name for pair in zip(line, line[1:])})
    assert named == edges, "the boundary is another"


try:
    main(*sys.argv[1:])
except AssertionError as error:
    sys.exit(f"{sys.argv[1]}: {error}")
