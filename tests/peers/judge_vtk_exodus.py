"""Reads our Exodus files with VTK: det J of every element by VTK's shape functions, blocks and side sets by name.

usage: judge_vtk_exodus.py {X.quad.h5|X.hex.h5 FILE.exo}...
"""
import sys
from functools import cache

import numpy, vtk
from vtk.util.numpy_support import vtk_to_numpy

from stage_measures import measures, plain, rule


@cache
def slopes(kind, dim, count):
    """Derivatives of VTK's shape functions at rule(dim), by coordinates from -1 to 1: [point, node, direction]."""
    cell, found = vtk.vtkGenericCell(), []
    cell.SetCellType(kind)
    for point in rule(dim)[0]:
        found.append([0.0] * (dim * count))
        cell.GetRepresentativeCell().InterpolateDerivs([(1 + x) / 2 for x in point] + [0] * (3 - dim), found[-1])
    return numpy.array(found).reshape(len(found), dim, count).transpose(0, 2, 1) / 2


def dets(grid, dim):
    (kind,) = set(vtk_to_numpy(grid.GetCellTypesArray()))
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(grid.GetNumberOfCells(), -1)
    x = vtk_to_numpy(grid.GetPoints().GetData())[cells]
    columns = numpy.einsum("pnd,ena->depa", slopes(kind, dim, cells.shape[1]), x)
    if dim == 3:
        return numpy.einsum("epa,epa->ep", columns[0], numpy.cross(columns[1], columns[2]))
    return numpy.cross(*columns)[..., 2]


def named(blocks):
    """The filled pieces of a vtkMultiBlockDataSet by name."""
    found = {}
    for k in range(blocks.GetNumberOfBlocks()):
        if blocks.GetBlock(k) is not None and blocks.GetBlock(k).GetNumberOfCells() > 0:
            found[blocks.GetMetaData(k).Get(vtk.vtkCompositeDataSet.NAME())] = blocks.GetBlock(k)
    return found


def judge(stage, path):
    wanted = measures(stage)
    dim, parts = wanted.dimension, (wanted.order + 1) // 2
    reader = vtk.vtkExodusIIReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    reader.GenerateGlobalElementIdArrayOff()
    for k in range(reader.GetNumberOfSideSetArrays()):
        reader.SetSideSetArrayStatus(reader.GetSideSetArrayName(k), 1)
    reader.Update()
    blocks, sides = named(reader.GetOutput().GetBlock(0)), named(reader.GetOutput().GetBlock(4))
    regions = {plain(name) for of, name in wanted.groups if of == dim}
    assert {name.split(" ID: ")[0].removeprefix("Unnamed block") for name in blocks} == regions, (path, set(blocks))
    counts = {plain(name): len(rows) * parts ** (dim - 1) for name, rows in wanted.middles.items()}
    found = {name.split(" ID: ")[0]: piece.GetNumberOfCells() for name, piece in sides.items()}
    assert found == counts, (path, found, counts)
    there = numpy.concatenate([dets(grid, dim) for grid in blocks.values()])
    assert there.min() > 0 and len(there) == len(wanted.dets) * parts ** dim, (path, there.shape, there.min())
    if parts == 1:
        off = numpy.abs(there / wanted.dets[wanted.sequence] - 1).max()
        assert off < 1e-4, (path, "det J differs by", off)  # VTK has positions in single precision


for case in zip(*(iter(sys.argv[1:]),) * 2):
    judge(*case)
print(f"{len(sys.argv[1:]) // 2} files")
