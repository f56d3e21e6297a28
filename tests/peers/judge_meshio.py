"""Reads our MSH files with meshio: numbers of nodes, elements and their groups against x.quad.h5; the area too.

usage: judge_meshio.py X.quad.h5 FILE.msh...
"""
import sys

import meshio, numpy

from quad_file import QuadFile


def groups_of(mesh):
    """(dimension, name) -> number of elements."""
    names = {(int(dim), int(tag)): name for name, (tag, dim) in mesh.field_data.items()}
    counts = {}
    for block, tags in zip(mesh.cells, mesh.cell_data["gmsh:physical"]):
        dim = 1 if block.type.startswith("line") else 2
        for tag in tags:
            counts[dim, names[dim, int(tag)]] = counts.get((dim, names[dim, int(tag)]), 0) + 1
    return counts


def main():
    quads = QuadFile(sys.argv[1])
    boundaries, regions = quads.groups()
    wanted = {(1, name): count for name, count in boundaries.items()} | {(2, name): c for name, c in regions.items()}
    width = quads.order + 1
    types = {"line" + (str(width) if width > 2 else ""), "quad" + (str(width**2) if width > 2 else "")}
    corners = quads.nodes[quads.elems[:, [0, 0, -1, -1], [0, -1, -1, 0]]]
    for path in sys.argv[2:]:
        mesh = meshio.read(path)
        assert len(mesh.points) == len(quads.nodes), (path, len(mesh.points), len(quads.nodes))
        assert {block.type for block in mesh.cells} == types, (path, {block.type for block in mesh.cells}, types)
        found = groups_of(mesh)
        assert found == wanted, (path, found, wanted)
        theirs = numpy.concatenate([mesh.points[b.data[:, :4]] for b in mesh.cells if b.type.startswith("quad")])
        order = numpy.argsort(quads.block, kind="stable")
        assert numpy.array_equal(theirs[..., :2], corners[order]), (path, "corners differ")
        print(f"{path}: {len(mesh.points)} nodes, {len(found)} groups")


main()
