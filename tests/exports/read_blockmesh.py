#!/usr/bin/env python3
"""Reads a blockMeshDict as OpenFOAM's blockMesh does, in the plane, and compares its cells to the stage file.

usage: read_blockmesh.py blockMeshDict x.quad.h5 [constant/polyMesh/points]

Prints "cells C blocks B moved M": M is the largest distance of a cell's corner from the stage file's, in its unit. With
the points that blockMesh itself has made, these must be ours. Ends with 1 and a sentence where anything else differs."""
import re
import sys
from math import dist
from pathlib import Path

import stage_mesh

TOKEN = re.compile(r'[(){};]|[^\s(){};]+')


def parsed(tokens):
    """Nested lists of words up to the closing bracket; a dictionary {...} is a list after its name."""
    items = []
    for token in tokens:
        if token in ")}":
            return items
        items.append(parsed(tokens) if token in "({" else token)
    return items


def entries(path):
    """name -> what stands between the name and the semicolon (or the dictionary in braces)."""
    items = parsed(iter(TOKEN.findall(Path(path).read_text(encoding="ascii"))))
    found, at = {}, 0
    while at < len(items):
        name, value = items[at], items[at + 1]
        at += 2 + (at + 2 < len(items) and items[at + 2] == ";")
        found[name] = value
    return found


def position(xyz):
    return tuple(map(float, xyz))


class Line:
    """blockMesh's edge: a straight one, or a spline through points, walked by the length of the polygon. Only the
    points themselves are asked for, which the spline passes exactly."""

    def __init__(self, points):
        self.points, self.at = points, [0.0]
        for a, b in zip(points, points[1:]):
            self.at.append(self.at[-1] + dist(a, b))
        self.at = [s / self.at[-1] for s in self.at]

    def point(self, share):
        if len(self.points) == 2:
            a, b = self.points
            return tuple(p + share * (q - p) for p, q in zip(a, b))
        k = min(range(len(self.at)), key=lambda m: abs(self.at[m] - share))
        assert abs(self.at[k] - share) < 1e-12, "a cell ends between points of the spline"
        return self.points[k]


def divisions(grading, count):
    """Shares at which the cells end, from sections of (length, cells, ratio), all with ratio 1 here."""
    if not isinstance(grading, list):
        assert float(grading) == 1
        return [k / count for k in range(count + 1)]
    lengths = [float(length) for length, cells, ratio in grading]
    assert all(cells == "1" and ratio == "1" for _, cells, ratio in grading) and len(grading) == count
    shares, total = [0.0], sum(lengths)
    for length in lengths:
        shares.append(shares[-1] + length / total)
    return shares[:-1] + [1.0]


class Dict:
    def __init__(self, path, metres):
        """metres: of one unit of the stage file; the numbers are metres themselves where patches are cyclic."""
        found = entries(path)
        is_cyclic = "cyclic" in [body[1] for body in found["boundary"][1::2]]
        unit = metres if is_cyclic else 1.0
        self.scale = float(found["scale"]) * unit
        self.vertices = [tuple(x / unit for x in position(v)) for v in found["vertices"]]
        half = len(self.vertices) // 2
        heights = {v[2] for v in self.vertices[half:]}
        assert {v[2] for v in self.vertices[:half]} == {0.0} and len(heights) == 1 and min(heights) > 0
        assert [v[:2] for v in self.vertices[:half]] == [v[:2] for v in self.vertices[half:]]
        self.half = half
        self.splines = {}
        edges = found["edges"]
        for word, a, b, points in zip(*(edges[k::4] for k in range(4))):
            assert word == "spline" and (int(a), int(b)) not in self.splines
            self.splines[int(a), int(b)] = [tuple(x / unit for x in position(p)) for p in points]
        self.blocks = blocks_of(found["blocks"])
        self.patches = patches_of(found["boundary"])
        self.check_upper_plane()

    def check_upper_plane(self):
        for (a, b), points in self.splines.items():
            if a < self.half:
                above = self.splines[a + self.half, b + self.half]
                assert [p[:2] for p in points] == [p[:2] for p in above] and all(p[2] == 0 for p in points)
        for corners, *_ in self.blocks:
            assert [c + self.half for c in corners[:4]] == corners[4:]

    def line(self, a, b):
        ends = self.vertices[a], self.vertices[b]
        if (a, b) in self.splines:
            return Line([ends[0], *self.splines[a, b], ends[1]])
        if (b, a) in self.splines:
            return Line([ends[0], *reversed(self.splines[b, a]), ends[1]])
        return Line(list(ends))


def blocks_of(items):
    blocks = []
    for word, corners, zone, counts, how, grading in zip(*(items[k::6] for k in range(6))):
        assert word == "hex" and counts[2] == "1"
        if how == "simpleGrading":
            grading = ["1"] * 12 if grading == ["1"] * 3 else None
        assert len(grading) == 12 and grading[8:] == ["1"] * 4
        assert grading[0] == grading[3] and grading[1] == grading[2] and grading[4] == grading[7]
        blocks.append(([int(c) for c in corners], zone, int(counts[0]), int(counts[1]), grading))
    return blocks


def patches_of(items):
    patches = {}
    for name, body in zip(items[::2], items[1::2]):
        if body[:2] == ["type", "cyclic"]:  # whose transform OpenFOAM checks
            assert "faces" in body and name not in patches
            patches[name] = [[int(v) for v in face] for face in body[body.index("faces") + 1]]
            continue
        assert body[0] == "type" and body[3] == "faces" and name not in patches
        assert body[1] == ("empty" if name == "frontAndBack" else "wall" if name.startswith("wall") else "patch")
        patches[name] = [[int(v) for v in face] for face in body[4]]
    return patches


def mean(low, low_weight, high, high_weight):
    total = low_weight + high_weight
    return tuple((low_weight * a + high_weight * b) / total for a, b in zip(low, high))


def block_points(mesh, block):
    """blockMesh's own interpolation at z = 0: for each pair of opposite edges a weighted mean of the points on the
    straight edges and of the curves' distances from them."""
    (a, b, c, d), (_, _, num_i, num_j, grading) = block[0][:4], block
    ends = ((a, b), (d, c), (a, d), (b, c))
    shares = [divisions(grading[k], count) for k, count in ((0, num_i), (1, num_i), (4, num_j), (5, num_j))]
    on_line = [[mesh.line(*ends[k]).point(s) for s in shares[k]] for k in range(4)]
    A, B, C, D = (mesh.vertices[v] for v in (a, b, c, d))
    corner_pairs = ((A, B), (D, C), (A, D), (B, C))
    grid = {}
    for j in range(num_j + 1):
        for i in range(num_i + 1):
            x1, x2, y1, y2 = shares[0][i], shares[1][i], shares[2][j], shares[3][j]
            wx = ((1 - x1) * (1 - y1) + x1 * (1 - y2), (1 - x2) * y1 + x2 * y2)
            wy = ((1 - y1) * (1 - x1) + y1 * (1 - x2), (1 - y2) * x1 + y2 * x2)
            wz = ((1 - x1) * (1 - y1), x1 * (1 - y2), x2 * y2, (1 - x2) * y1)
            straight = [tuple(p + s * (q - p) for p, q in zip(*corner_pairs[k]))
                        for k, s in enumerate((x1, x2, y1, y2))]
            curve = (on_line[0][i], on_line[1][i], on_line[2][j], on_line[3][j])
            bend = [tuple(p - q for p, q in zip(curve[k], straight[k])) for k in range(4)]
            flat = mean(straight[0], wx[0], straight[1], wx[1]), mean(straight[2], wy[0], straight[3], wy[1])
            bent = mean(bend[0], wx[0], bend[1], wx[1]), mean(bend[2], wy[0], bend[3], wy[1])
            corners = tuple(sum(w * v[k] for w, v in zip(wz, (A, B, C, D))) / sum(wz) for k in range(3))
            grid[i, j] = tuple((flat[0][k] + flat[1][k] + corners[k]) / 3 + bent[0][k] + bent[1][k] for k in range(3))
    return grid


def cells_of(mesh):
    """(corners counter-clockwise, zone, patch of each side) of every cell in the lower plane."""
    patch_of = {}
    for name, faces in mesh.patches.items():
        for face in faces:
            assert frozenset(face) not in patch_of
            patch_of[frozenset(face)] = name
    unused, cells = set(patch_of), []
    for block in mesh.blocks:
        (a, b, c, d), zone, num_i, num_j = block[0][:4], *block[1:4]
        grid = block_points(mesh, block)
        unused -= {frozenset(block[0][:4]), frozenset(block[0][4:])}
        sides = []
        for p, q in ((a, b), (b, c), (c, d), (d, a)):
            face = frozenset((p, q, p + mesh.half, q + mesh.half))
            unused.discard(face)
            sides.append(patch_of.get(face))
        for j in range(num_j):
            for i in range(num_i):
                names = [sides[k] if ends else None
                         for k, ends in enumerate((j == 0, i == num_i - 1, j == num_j - 1, i == 0))]
                cells.append(([grid[i, j], grid[i + 1, j], grid[i + 1, j + 1], grid[i, j + 1]], zone, names))
    assert not unused, "a face of a patch is no face of a block"
    return cells


def centre(corners):
    return tuple(sum(x) / 4 for x in zip(*corners))


def plain(name):
    """A name as blockMesh can read it (none of ours here falls together with another)."""
    word = re.sub(r"[^A-Za-z0-9_.-]", "_", name)
    return word if re.match(r"[A-Za-z_]", word) else "_" + word


def compare(cells, wanted):
    """The largest distance between corners."""
    assert len(cells) == len(wanted.elements), f"{len(cells)} cells for {len(wanted.elements)}"
    n, size = wanted.order, (wanted.order + 1) ** 2
    corners = [[e[0], e[n], e[size - 1], e[size - 1 - n]] for e in wanted.elements]
    by_x = sorted(range(len(corners)), key=lambda e: centre(corners[e])[0])
    places = [centre(corners[e]) for e in by_x]
    taken, moved = set(), 0.0
    for found, zone, names in cells:
        middle = centre(found)
        k = min(range(len(places)), key=lambda m: dist(places[m], middle))
        e = by_x[k]
        assert e not in taken, f"two cells at element {e}"
        taken.add(e)
        turn = min(range(4), key=lambda t: sum(dist(found[c], corners[e][(c + t) % 4]) for c in range(4)))
        for c in range(4):
            moved = max(moved, dist(found[c], corners[e][(c + turn) % 4]))
            name = wanted.boundaries.get((e, (c + turn) % 4))
            assert names[c] == (name and plain(name)), f"side {(c + turn) % 4} of element {e} is {names[c]} for {name}"
        assert zone == plain(wanted.regions[e]), f"element {e} is in {zone} for {wanted.regions[e]}"
    return moved


def check_made(path, cells, mesh, diameter):
    """Every point of blockMesh's lower plane is a corner of a cell here, and the other way round."""
    text = Path(path).read_text(encoding="ascii")
    made = [position(m.split()) for m in re.findall(r"\(([-+0-9.e ]+)\)", text)]
    lower = sorted(tuple(x / mesh.scale for x in p) for p in made if p[2] < 1e-9 * diameter * mesh.scale)
    ours, tolerance = [], 1e-9 * diameter
    for p in sorted(p for corners, _, _ in cells for p in corners):
        near = (q for q in reversed(ours) if p[0] - q[0] < tolerance)
        if not any(dist(p, q) < tolerance for q in near):
            ours.append(p)
    assert len(lower) == len(ours) and 2 * len(lower) == len(made), f"{len(lower)} points for {len(ours)}"
    for p in lower:
        assert min(dist(p, q) for q in ours) < tolerance, f"blockMesh has a point {p} that is not ours"


def main(words):
    if len(words) not in (2, 3):
        sys.exit(__doc__)
    wanted = stage_mesh.read(words[1])
    mesh = Dict(words[0], wanted.metres)
    try:
        cells = cells_of(mesh)
        moved = compare(cells, wanted)
        if len(words) == 3:
            check_made(words[2], cells, mesh, wanted.diameter)
    except AssertionError as error:
        sys.exit(f"{words[0]}: {error}")
    print(f"cells {len(cells)} blocks {len(mesh.blocks)} moved {moved:.2g}")


if __name__ == "__main__":
    main(sys.argv[1:])
