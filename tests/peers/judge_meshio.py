"""Reads our files with meshio: elements with their corners, sides and nodes under their names, as far as meshio 5.0 has
them: of MSH and Abaqus names, of SU2 the number of each marker, of Exodus elements alone.

usage: judge_meshio.py {X.quad.h5|X.hex.h5 FILE}...
"""
import io, sys
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path

import meshio, numpy

from stage_measures import measures, plain


def types(order, dim):
    """meshio's names of a side and of an element."""
    count = [(order + 1) ** d if order > 1 else "" for d in range(4)]
    return {2: ("line", "quad"), 3: ("quad", "hexahedron")}[dim][0] + str(count[dim - 1]), \
        {2: "quad", 3: "hexahedron"}[dim] + str(count[dim])


def counts(wanted):
    return {key: count for key, (count, _) in wanted.groups.items()}


def require_corners(cells, points, wanted, sequence):
    found = numpy.concatenate([points[data[:, :2 ** wanted.dimension]] for data in cells])
    off = numpy.abs(found[..., :wanted.corners.shape[2]] - wanted.corners[sequence]).max()
    assert off < 1e-13 * numpy.abs(wanted.corners).max(), ("corners differ by", off)


def judge_msh(mesh, wanted):
    dim, (side, element) = wanted.dimension, types(wanted.order, wanted.dimension)
    assert {block.type for block in mesh.cells} == {side, element}, {block.type for block in mesh.cells}
    assert len(mesh.points) == wanted.num_nodes
    names = {(int(of), int(tag)): name for name, (tag, of) in mesh.field_data.items()}
    found = {}
    for block, tags in zip(mesh.cells, mesh.cell_data["gmsh:physical"]):
        for tag in tags:
            key = dim if block.type == element else dim - 1
            key = key, names[key, int(tag)]
            found[key] = found.get(key, 0) + 1
    assert found == counts(wanted), (found, counts(wanted))
    require_corners([b.data for b in mesh.cells if b.type == element], mesh.points, wanted, wanted.sequence)


def judge_inp(mesh, wanted):
    names = {plain(name): rows for name, rows in wanted.middles.items()}
    assert set(mesh.point_sets) == set(names), (set(mesh.point_sets), set(names))
    for name, rows in names.items():  # the box of the nodes holds the middles of the sides
        x = mesh.points[mesh.point_sets[name]][:, :rows.shape[1]]
        edge = 1e-9 * numpy.ptp(wanted.corners)
        assert len(x) > len(rows) / 2, (name, len(x))
        assert (x.min(0) <= rows.min(0) + edge).all() and (x.max(0) >= rows.max(0) - edge).all(), name
    regions = {name for of, name in wanted.groups if of == wanted.dimension}
    assert set(mesh.cell_sets) == regions | {"EALL"}, mesh.cell_sets
    require_corners([b.data for b in mesh.cells], mesh.points, wanted, wanted.sequence)


def judge_su2(mesh, wanted):
    cells = dict((b.type, b.data) for b in mesh.cells)
    side, element = types(1, wanted.dimension)
    assert len(cells[element]) == len(wanted.dets) * wanted.order ** wanted.dimension
    tags = numpy.concatenate([t for b, t in zip(mesh.cells, mesh.cell_data["su2:tag"]) if b.type == side])
    found = list(numpy.bincount(tags.astype(int))[1:])
    sides = wanted.order ** (wanted.dimension - 1)
    assert found == [count * sides for (of, _), (count, _) in wanted.groups.items() if of < wanted.dimension], found


def judge_exo(mesh, wanted):
    (block,) = mesh.cells
    _, element = types(min(wanted.order, 2), wanted.dimension)
    parts = (wanted.order + 1) // 2
    assert block.type == element and len(block.data) == len(wanted.dets) * parts ** wanted.dimension
    if parts == 1:
        require_corners([block.data], mesh.points, wanted, wanted.sequence)


JUDGES = {".msh": judge_msh, ".inp": judge_inp, ".su2": judge_su2, ".exo": judge_exo}
for stage, path in zip(*(iter(sys.argv[1:]),) * 2):
    ending, silence = Path(path).suffix, io.StringIO()
    with redirect_stdout(silence), redirect_stderr(silence):  # it warns of markers that are words
        mesh = meshio.read(path, file_format="abaqus" if ending == ".inp" else None)
    try:
        JUDGES[ending](mesh, measures(stage))
    except AssertionError as error:
        raise AssertionError(path) from error
print(f"{len(sys.argv[1:]) // 2} files")
