"""Reads CGNS files of hexahedra of order 1 or 2 with VTK and compares the volume, by VTK's own shape functions, to
x.hex.h5.

usage: judge_vtk_cgns_hex.py {X.hex.h5 X.cgns}...
"""
import sys
from itertools import product
from pathlib import Path

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOCGNSReader import vtkCGNSReader

sys.path.insert(0, str(Path(__file__).parent.parent / "exports"))
import hex_mesh  # noqa: E402
from stage_hexes import stage  # noqa: E402


def judge(stage_file, path):
    wanted = sum(hex_mesh.measures(stage(stage_file))[0].values())
    reader = vtkCGNSReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput().GetBlock(0).GetBlock(0)
    assert isinstance(grid, vtk.vtkUnstructuredGrid), grid
    points, volume = vtk_to_numpy(grid.GetPoints().GetData()), 0.0
    at, weights = numpy.polynomial.legendre.leggauss(6)
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(grid.GetNumberOfCells(), -1)
    cell = grid.GetCell(0)
    for places in product(range(6), repeat=3):
        slopes = [0.0] * (3 * cells.shape[1])
        cell.InterpolateDerivs([(1 + at[k]) / 2 for k in places], slopes)
        dets = numpy.linalg.det(numpy.einsum("dn,enk->edk", numpy.reshape(slopes, (3, -1)), points[cells]))
        assert dets.min() > 0, dets.min()
        volume += float(dets.sum() * numpy.prod(weights[list(places)]) / 8)
    assert abs(volume - wanted) < 1e-8 * wanted, (volume, wanted)


for case in zip(*(iter(sys.argv[1:]),) * 2):
    judge(*case)
