"""Reads our MSH files with PETSc's DMPlex: cells, and under the label of each name its sides, at their places.

usage: judge_petsc.py CURVED {X.quad.h5|X.hex.h5 FILE.msh}...

CURVED is 1 where PETSc shall make a coordinate field of the order of the elements, which takes long at high orders.
"""
import sys

import numpy, petsc4py

petsc4py.init([])
from petsc4py import PETSc

from stage_measures import measures, sorted_rows


def middles(dm, points, dim):
    """Means of the corners of sides."""
    first, last = dm.getDepthStratum(0)
    x = dm.getCoordinates().getArray()
    section = dm.getCoordinateSection()
    found = []
    for point in points:
        corners = [p for p in dm.getTransitiveClosure(point)[0] if first <= p < last]
        assert len(corners) == 2 ** (dim - 1), (point, corners)
        found.append(numpy.mean([x[section.getOffset(p):][:dim] for p in corners], axis=0))
    return sorted_rows(found)


def labelled(dm, label):
    """The points of a label, which has one value."""
    (value,) = dm.getLabelIdIS(label).getIndices()
    return dm.getStratumIS(label, int(value)).getIndices()


def judge(stage, path):
    wanted = measures(stage)
    dim = wanted.dimension
    PETSc.Options().setValue("dm_plex_gmsh_spacedim", dim)
    dm = PETSc.DMPlex().createFromFile(path, comm=PETSc.COMM_SELF)
    first, last = dm.getHeightStratum(0)
    assert dm.getDimension() == dim and last - first == len(wanted.dets), (path, dm.getDimension(), first, last)
    names = {dm.getLabelName(k) for k in range(dm.getNumLabels())} - {"celltype", "depth"}
    assert names == {name for _, name in wanted.groups}, (path, names)
    for (of, name), (count, _) in wanted.groups.items():
        points = labelled(dm, name)
        assert len(points) == count, (path, name, len(points), count)
        if of < dim:
            off = numpy.abs(middles(dm, points, dim) - wanted.middles[name]).max()
            assert off < 1e-9 * numpy.ptp(wanted.corners), (path, name, off)
    dm.destroy()


PETSc.Options().setValue("dm_plex_gmsh_use_regions", True)
PETSc.Options().setValue("dm_plex_gmsh_highorder", sys.argv[1])
for case in zip(*(iter(sys.argv[2:]),) * 2):
    judge(*case)
print(f"{len(sys.argv[2:]) // 2} meshes")
