#!/usr/bin/env python3
"""Reads structured grids of hexahedra, PLOT3D with its neutral map or CGNS by h5py alone, by parsers that share nothing
with the writers, and compares them to the stage file.

usage: read_hex_grids x.xyz|x.cgns x.hex.h5

Prints "grids N", or what differs, and ends with 1 then. Checked are: points of connected faces are equal to the last
bit, each cell face on the outside of a grid has one boundary or one neighbour, transforms are those of the points,
grids are right-handed, the cells are those between the nodes of the elements, and boundaries have their names."""
import sys
from pathlib import Path

import h5py
import numpy

import hex_mesh
from element_mesh import real_names
from stage_hexes import stage


def key(points):
    """Of a cell or a face: the set of its points, to the last bit."""
    return frozenset(x.tobytes() for x in points.reshape(-1, 3) + 0.0)  # no -0


class Grids:
    """Points [i, j, k, axis] of each, and what lies at their outsides. Ranges are pairs of points that count from 1."""

    def __init__(self, points):
        self.points, self.outside = points, []
        for x in points:  # by axis and end: one True for each cell face that nothing was said about
            cells = numpy.array(x.shape[:3]) - 1
            self.outside.append({(axis, end): numpy.ones(numpy.delete(cells, axis), bool)
                                 for axis in range(3) for end in (0, 1)})
        self.names = {}

    def take(self, grid, first, last):
        """Points of a range in its order, as a slice of the grid; its cell faces are done."""
        first, last = numpy.array(first), numpy.array(last)
        axis, = numpy.flatnonzero(first == last)
        size = self.points[grid].shape[axis]
        assert first[axis] in (1, size), "a range inside the grid"
        low, high = numpy.delete(numpy.minimum(first, last), axis), numpy.delete(numpy.maximum(first, last), axis)
        left = self.outside[grid][axis, int(first[axis] == size)]
        part = tuple(slice(a - 1, b - 1) for a, b in zip(low, high))
        assert left[part].all() and left[part].size == numpy.prod(high - low), "a face twice, or beyond the grid"
        left[part] = False
        index = [numpy.arange(a, b + (1 if b >= a else -1), 1 if b >= a else -1) - 1 for a, b in zip(first, last)]
        return axis, self.points[grid][numpy.ix_(*index)]

    def add_boundary(self, grid, first, last, name):
        axis, points = self.take(grid, first, last)
        face = numpy.squeeze(points, axis)
        for a in range(face.shape[0] - 1):
            for b in range(face.shape[1] - 1):
                self.names[key(face[a:a + 2, b:b + 2])] = name


def read_plot3d(path):
    words = iter(Path(path).read_text(encoding="ascii").split())
    sizes = [tuple(int(next(words)) for _ in range(3)) for _ in range(int(next(words)))]
    points = [numpy.array([float(next(words)) for _ in range(3 * ni * nj * nk)]).reshape(3, nk, nj, ni).T
              for ni, nj, nk in sizes]
    assert next(words, None) is None, "something follows"
    grids, names = Grids(points), real_names(path)
    lines = Path(path).with_suffix(".nmf").read_text(encoding="ascii").splitlines()
    rows = [line.split() for line in lines if not line.startswith("#")]
    count = int(rows[0][0])
    assert [tuple(map(int, row)) for row in rows[1:count + 1]] == [(g, *size) for g, size in enumerate(sizes, 1)]

    def range_of(numbers):
        """Faces 1, 2: k, ranges of i, j; 3, 4: i, ranges of j, k; 5, 6: j, ranges of k, i."""
        grid, face, s1, e1, s2, e2 = map(int, numbers)
        axis = {1: 2, 2: 2, 3: 0, 4: 0, 5: 1, 6: 1}[face]
        fixed = 1 if face % 2 else sizes[grid - 1][axis]
        first, last = [fixed] * 3, [fixed] * 3
        first[(axis + 1) % 3], last[(axis + 1) % 3] = s1, e1
        first[(axis + 2) % 3], last[(axis + 2) % 3] = s2, e2
        return grid - 1, first, last

    def on_face(numbers):
        """Points [first range, second range]."""
        axis, taken = grids.take(*range_of(numbers))
        return numpy.moveaxis(taken, axis, 0)[0] if axis != 1 else numpy.swapaxes(taken[:, 0], 0, 1)

    for word, *numbers in rows[count + 1:]:
        if word != "ONE_TO_ONE":
            assert len(numbers) == 6
            grids.add_boundary(*range_of(numbers), names.get(word, word))
            continue
        own, donor = on_face(numbers[:6]), on_face(numbers[6:12])
        assert numbers[12:] in (["TRUE"], ["FALSE"])
        if numbers[12] == "TRUE":
            donor = numpy.swapaxes(donor, 0, 1)
        assert numpy.array_equal(own, donor), "connected points differ"
    return grids


def read_cgns(path):
    names, of_regions = real_names(path), real_names(path, "regions")
    with h5py.File(path) as file:
        assert list(file["base/ data"][()]) == [3, 3]
        zones = {name: zone for name, zone in file["base"].items() if zone.attrs.get("label", b"") == b"Zone_t"}
        number = {name: n for n, name in enumerate(zones)}

        def text(node):
            return bytes(node[" data"][()].astype(numpy.uint8)).decode()

        points, regions = [], []
        for zone in zones.values():
            x = numpy.stack([zone[f"GridCoordinates/Coordinate{axis}/ data"][()].T for axis in "XYZ"], axis=-1)
            size = zone[" data"][()]
            assert text(zone["ZoneType"]) == "Structured" and tuple(size[0]) == x.shape[:3]
            assert tuple(size[1]) == tuple(n - 1 for n in x.shape[:3]) and not size[2].any()
            points.append(x)
            regions.append(of_regions.get(text(zone["FamilyName"]), text(zone["FamilyName"])))
        grids = Grids(points)
        for name, zone in zones.items():
            for part in zone["ZoneBC"].values() if "ZoneBC" in zone else []:
                first, last = part["PointRange/ data"][()]
                word = text(part["FamilyName"])
                assert word in file["base"]
                grids.add_boundary(number[name], first, last, names.get(word, word))
            for part in zone["ZoneGridConnectivity"].values() if "ZoneGridConnectivity" in zone else []:
                check_connection(grids, number[name], number[text(part)],
                                 *(part[what + "/ data"][()]
                                   for what in ("PointRange", "PointRangeDonor", "Transform")))
    return grids, regions


def check_connection(grids, own, donor, points, others, transform):
    """Each connection is there from both sides, so that only its own faces are done."""
    axis, taken = grids.take(own, *points)
    axes = [abs(t) - 1 for t in transform]
    steps = numpy.zeros((3, 3), int)
    for a, t in enumerate(transform):
        steps[abs(t) - 1, a] = 1 if t > 0 else -1
    assert round(numpy.linalg.det(steps)) == 1, "the transform is no rotation"
    assert numpy.array_equal(others[0] + steps @ (points[1] - points[0]), others[1]), "the transform has another end"
    index = [numpy.arange(a, b + (1 if b >= a else -1), 1 if b >= a else -1) - 1 for a, b in zip(*others)]
    beyond = grids.points[donor][numpy.ix_(*index)]
    assert numpy.array_equal(taken, numpy.transpose(beyond, axes + [3])), "connected points differ"
    assert points[0][axis] == points[1][axis]


def compare(grids, regions, wanted):
    left = sum(int(sides.sum()) for outside in grids.outside for sides in outside.values())
    assert left == 0, f"{left} faces have no line"
    cells, of_cells = [], []
    for g, x in enumerate(grids.points):
        x = numpy.transpose(x, (2, 1, 0, 3))
        own = [x[k:k + 2, j:j + 2, i:i + 2] for k in range(x.shape[0] - 1) for j in range(x.shape[1] - 1)
               for i in range(x.shape[2] - 1)]
        cells += own
        of_cells += [regions[g] if regions else None] * len(own)
    found = hex_mesh.HexElements(1, numpy.array(cells), None, [])
    assert hex_mesh.dets(found)[0].min() > 0, "a grid is left-handed or folded"
    wanted = hex_mesh.cut_at_nodes(wanted)

    region_of = {key(cell): region for cell, region in zip(wanted.nodes, wanted.regions)}
    assert len(cells) == len(region_of) and {key(cell) for cell in cells} == set(region_of), "the cells are others"
    if regions:
        assert all(region_of[key(cell)] == region for cell, region in zip(cells, of_cells)), "a grid has another region"
    named = {key(wanted.face_nodes(elem, face)): name for elem, face, name in wanted.faces}
    assert all(named.get(face) == name for face, name in grids.names.items()), "a boundary is another"
    inner = [face for face in named if face not in grids.names]
    assert {named[face] for face in inner}.isdisjoint(grids.names.values()), "parts of a boundary are missing"


try:
    if sys.argv[1].endswith(".cgns"):
        all_grids, all_regions = read_cgns(sys.argv[1])
    else:
        all_grids, all_regions = read_plot3d(sys.argv[1]), None
    compare(all_grids, all_regions, stage(sys.argv[2]))
except AssertionError as error:
    sys.exit(f"{sys.argv[1]}: {error}")
print(f"grids {len(all_grids.points)}")
