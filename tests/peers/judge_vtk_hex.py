"""Reads our VTU files of hexahedra with VTK and compares volumes of regions and areas of named faces, by VTK's own
shape functions, to x.hex.h5.

usage: judge_vtk_hex.py X.hex.h5 FILE.vtu [FILE.vtu ...]       (each with its FILE.faces.vtu beside it)
"""
import sys
from itertools import product
from pathlib import Path

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

sys.path.insert(0, str(Path(__file__).parent.parent / "exports"))
import hex_mesh  # noqa: E402
from stage_hexes import stage  # noqa: E402


def measures(path, dimension, data, names):
    """Volumes, or areas, by name; refuses cells with a determinant that is not positive."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(grid.GetNumberOfCells(), -1)
    cell = grid.GetCell(0)
    cell.SetUniformOrderFromNumPoints(cells.shape[1])
    at, weights = numpy.polynomial.legendre.leggauss(10)
    slopes, parts = [], []
    for places in product(range(10), repeat=dimension):
        slopes.append([0.0] * (dimension * cells.shape[1]))
        cell.InterpolateDerivs([(1 + at[k]) / 2 for k in places] + [0] * (3 - dimension), slopes[-1])
        parts.append(numpy.prod(weights[list(places)]) / 2 ** dimension)
    slopes = numpy.array(slopes).reshape(len(parts), cells.shape[1], dimension)
    j = numpy.einsum("gnd,enk->egdk", slopes, vtk_to_numpy(grid.GetPoints().GetData())[cells])
    dets = numpy.linalg.det(j) if dimension == 3 else numpy.linalg.norm(numpy.cross(j[:, :, 0], j[:, :, 1]), axis=2)
    assert dets.min() > 0, (path, dets.min())
    texts = grid.GetFieldData().GetAbstractArray(names)
    found = {}
    for value, size in zip(vtk_to_numpy(grid.GetCellData().GetArray(data)), dets @ numpy.array(parts)):
        found[texts.GetValue(int(value))] = found.get(texts.GetValue(int(value)), 0) + float(size)
    return found


wanted = hex_mesh.measures(stage(sys.argv[1]))
for file in sys.argv[2:]:
    volumes = measures(file, 3, "region_id", "region_names")
    areas = measures(file[:-len(".vtu")] + ".faces.vtu", 2, "name_id", "boundary_names")
    said = hex_mesh.equal((volumes, areas), wanted, 1e-8)
    assert not said, (file, said)
