"""Reads our VTU files with VTK: det J of every element by VTK's own shape functions, regions and boundaries by name.

usage: judge_vtk_shapes.py {X.quad.h5|X.hex.h5 FILE.vtu}...     (with FILE.curves.vtu or FILE.faces.vtu beside it)
"""
import sys
from functools import cache

import numpy, vtk
from vtk.util.numpy_support import vtk_to_numpy

from quad_file import gll, lagrange
from stage_measures import add, differences, measures, rule

CLASSES = {68: vtk.vtkLagrangeCurve, 70: vtk.vtkLagrangeQuadrilateral, 72: vtk.vtkLagrangeHexahedron,
           75: vtk.vtkBezierCurve, 77: vtk.vtkBezierQuadrilateral, 79: vtk.vtkBezierHexahedron}


@cache
def slopes(kind, dim, count):
    """Derivatives of VTK's shape functions at rule(dim), by coordinates from -1 to 1: [point, node, direction]."""
    cell = CLASSES[kind]()
    cell.GetPoints().SetNumberOfPoints(count)
    cell.GetPointIds().SetNumberOfIds(count)
    cell.SetUniformOrderFromNumPoints(count)
    points, _ = rule(dim)
    found = []
    for point in points:
        found.append([0.0] * (dim * count))
        cell.InterpolateDerivs([(1 + x) / 2 for x in point] + [0] * (3 - dim), found[-1])
    return numpy.array(found).reshape(len(points), count, dim) / 2


@cache
def slopes_of_curve(kind, count):
    """The same of curves, whose derivatives VTK 9.1 lists in another sequence than its functions."""
    cell, points = CLASSES[kind](), gll(count - 1)
    cell.GetPoints().SetNumberOfPoints(count)
    cell.GetPointIds().SetNumberOfIds(count)
    values = []
    for point in points:
        values.append([0.0] * count)
        cell.InterpolateFunctions([(1 + point) / 2, 0, 0], values[-1])
    return (lagrange(points, rule(1)[0][:, 0])[1] @ numpy.array(values))[..., None]


def read(path, dim):
    """The grid, and the determinants [element, point] of its cells; of cells of lower dimension the stretch."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    (kind,) = set(vtk_to_numpy(grid.GetCellTypesArray()))
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(grid.GetNumberOfCells(), -1)
    slope = slopes_of_curve(kind, cells.shape[1]) if dim == 1 else slopes(kind, dim, cells.shape[1])
    columns = numpy.einsum("pnd,ena->depa", slope, vtk_to_numpy(grid.GetPoints().GetData())[cells])
    if dim == 3:
        return grid, numpy.einsum("epa,epa->ep", columns[0], numpy.cross(columns[1], columns[2]))
    return grid, numpy.cross(*columns) if dim == 2 else columns[0]


def by_name(grid, sizes, dim, data, texts):
    """Groups, as in Measures: those of block lines, which are neither boundaries nor interfaces, have no name."""
    texts, groups = grid.GetFieldData().GetAbstractArray(texts), {}
    for number, size in zip(vtk_to_numpy(grid.GetCellData().GetArray(data)), sizes @ rule(dim)[1]):
        if 0 <= number < texts.GetNumberOfValues():
            add(groups, (dim, texts.GetValue(int(number))), size)
    return groups


def judge(stage, path):
    wanted = measures(stage)
    dim = wanted.dimension
    grid, dets = read(path, dim)
    dets = dets[..., 2] if dim == 2 else dets
    assert dets.shape == wanted.dets.shape and dets.min() > 0, (path, dets.shape, dets.min())
    off = numpy.abs(dets / wanted.dets - 1).max()
    assert off < 1e-7, (path, "det J differs by", off)
    sides, sizes = read(path.removesuffix("vtu") + ("curves.vtu" if dim == 2 else "faces.vtu"), dim - 1)
    groups = by_name(sides, numpy.linalg.norm(sizes, axis=-1), dim - 1, "name_id", "boundary_names")
    if dim == 3:
        groups |= by_name(grid, dets, dim, "region_id", "region_names")
    # judge_vtk.py compares the blocks of quads.
    said = differences(groups, {key: value for key, value in wanted.groups.items() if key != (2, "domain") or dim == 3})
    assert not said, (path, said)


vtk.vtkObject.GlobalWarningDisplayOff()  # it warns of degrees that might depend on the direction; they do not
for case in zip(*(iter(sys.argv[1:]),) * 2):
    judge(*case)
print(f"{len(sys.argv[1:]) // 2} meshes")
