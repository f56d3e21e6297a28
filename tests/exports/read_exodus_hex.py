"""Exodus II files of hexahedra: HEX8, HEX20 and HEX27 by the manual's figures (SAND92-2137 and its additions), sides 1
to 6 of element blocks. Nodes that HEX20 has not are those of its shape functions."""
import numpy

from element_mesh import real_names
from hex_mesh import CORNERS, FACES, HexElements, without_inner_nodes
from read_exodus import open_classic, rows

# Corners (from 1) of the sides 1 to 6, and of the edges whose middles follow the corners.
SIDES = [(1, 2, 6, 5), (2, 3, 7, 6), (3, 4, 8, 7), (1, 5, 8, 4), (1, 4, 3, 2), (5, 6, 7, 8)]
MIDDLES = "12 23 34 41 15 26 37 48 56 67 78 85".split()
# Then the middle of all, and of these faces.
OF_FACES = [(1, 2, 3, 4), (5, 6, 7, 8), (1, 4, 8, 5), (2, 3, 7, 6), (1, 2, 6, 5), (4, 3, 7, 8)]


def places(corners):
    """The indices (k, j, i) in a grid of 3 x 3 x 3 that lie in the middle of these corners, which count from 1."""
    middle = 2 * numpy.mean([CORNERS[c - 1] for c in corners], axis=0)
    return tuple(int(index) for index in middle[::-1])


ORDER = ([places([c]) for c in range(1, 9)] + [places(map(int, edge)) for edge in MIDDLES]
         + [places(range(1, 9))] + [places(face) for face in OF_FACES])


def grid_of(points):
    """[element, k, j, i, axis] of points [element, node, axis]."""
    order = 1 if points.shape[1] == 8 else 2
    nodes = numpy.full((len(points), order + 1, order + 1, order + 1, 3), numpy.nan)
    for n, (k, j, i) in enumerate(ORDER[:points.shape[1]]):
        nodes[:, k * order // 2, j * order // 2, i * order // 2] = points[:, n]
    return without_inner_nodes(nodes) if points.shape[1] == 20 else nodes


def read(path):
    file = open_classic(path)
    x = numpy.array([file.variables[f"coord{c}"][2] for c in "xyz"]).T
    sizes = dict(file.sizes)
    assert sizes["num_nodes"] == len(x) and sizes["num_dim"] == 3
    names, of_regions, all_nodes, grids, regions = real_names(path), real_names(path, "regions"), [], [], []
    for block, word in enumerate(rows(file.variables["eb_names"]), 1):
        (_, size), attributes, nodes = file.variables[f"connect{block}"]
        assert attributes["elem_type"] == b"HEX%d" % size
        own = numpy.array(nodes).reshape(-1, size) - 1
        all_nodes.append(own.ravel())
        grids.append(grid_of(x[own]))
        regions += [of_regions.get(word, word)] * len(own)
    assert set(numpy.concatenate(all_nodes)) == set(range(len(x))) and sizes["num_elem"] == len(regions)
    faces = []
    for number, word in enumerate(rows(file.variables["ss_names"]), 1):
        for elem, side in zip(*(file.variables[f"{what}_ss{number}"][2] for what in ("elem", "side"))):
            corners = {c - 1 for c in SIDES[side - 1]}
            face, = (f for f, own in enumerate(FACES) if set(own) == corners)
            faces.append((elem - 1, face, names.get(word, word)))
    nodes = numpy.concatenate(grids)
    assert len(set(faces)) == len(faces)
    return HexElements(nodes.shape[1] - 1, nodes, regions, faces)
