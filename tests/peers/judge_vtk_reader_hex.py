"""Reads CGNS and Exodus files of hexahedra of order 1 or 2 with VTK and compares the volume, by VTK's own shape functions,
to x.hex.h5, and of Exodus the names of blocks and side sets and how many sides these have.

usage: judge_vtk_reader_hex.py {X.hex.h5 X.cgns|X.exo}...
"""
import sys
from collections import Counter
from itertools import product
from pathlib import Path

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOCGNSReader import vtkCGNSReader

sys.path.insert(0, str(Path(__file__).parent.parent / "exports"))
import hex_mesh  # noqa: E402
from stage_hexes import stage  # noqa: E402

POINTS = 6  # of Gauss quadrature in each direction: exact for the polynomials of order 2


def cgns_grid(path):
    reader = vtkCGNSReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput().GetBlock(0).GetBlock(0)


def exodus_grid(path, of_stage):
    """The first element block, once the names are those of the stage file."""
    reader = vtk.vtkExodusIIReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    side_sets = {reader.GetSideSetArrayName(k): k for k in range(reader.GetNumberOfSideSetArrays())}
    blocks = {reader.GetElementBlockArrayName(k).split(" Type:")[0] for k in range(reader.GetNumberOfElementBlockArrays())}
    for name in side_sets:
        reader.SetSideSetArrayStatus(name, 1)
    reader.Update()
    counts = {name: reader.GetOutput().GetBlock(4).GetBlock(k).GetNumberOfCells() for name, k in side_sets.items()}
    assert counts == Counter(name for _, _, name in of_stage.faces), counts
    assert blocks == set(of_stage.regions), blocks
    return reader.GetOutput().GetBlock(0).GetBlock(0)


def judge(stage_file, path):
    of_stage = stage(stage_file)
    grid = cgns_grid(path) if path.endswith(".cgns") else exodus_grid(path, of_stage)
    assert isinstance(grid, vtk.vtkUnstructuredGrid), grid
    if grid.GetCell(0).GetNumberOfPoints() == 20:
        of_stage.nodes = hex_mesh.without_inner_nodes(of_stage.nodes)
    wanted = sum(hex_mesh.measures(of_stage)[0].values())
    points, volume = vtk_to_numpy(grid.GetPoints().GetData()), 0.0
    at, weights = numpy.polynomial.legendre.leggauss(POINTS)
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(grid.GetNumberOfCells(), -1)
    cell = grid.GetCell(0)
    for places in product(range(POINTS), repeat=3):
        slopes = [0.0] * (3 * cells.shape[1])
        cell.InterpolateDerivs([(1 + at[k]) / 2 for k in places], slopes)
        dets = numpy.linalg.det(numpy.einsum("dn,enk->edk", numpy.reshape(slopes, (3, -1)), points[cells]))
        assert dets.min() > 0, (path, dets.min())
        volume += float(dets.sum() * numpy.prod(weights[list(places)]) / 8)
    tolerance = 1e-7 if points.dtype == numpy.float32 else 1e-8  # VTK's reader of Exodus files rounds coordinates
    assert abs(volume - wanted) < tolerance * wanted, (path, volume, wanted)


for case in zip(*(iter(sys.argv[1:]),) * 2):
    judge(*case)
