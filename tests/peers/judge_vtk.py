"""Reads our VTU files with VTK and evaluates VTK's own shape functions on them, against x.quad.h5.

usage: judge_vtk.py {X.quad.h5 LAGRANGE.vtu BEZIER.vtu}...       (each with its FILE.curves.vtu beside it)
"""
import sys

import numpy, vtk
from vtk.util.numpy_support import vtk_to_numpy

from quad_file import QuadFile, gll, lagrange


class Grid:
    """A file of cells of one type with one number of nodes."""

    def __init__(self, path):
        reader = vtk.vtkXMLUnstructuredGridReader()
        reader.SetFileName(path)
        reader.Update()
        self.grid = reader.GetOutput()
        self.count = self.grid.GetNumberOfCells()
        assert self.count > 0, path
        self.type = self.grid.GetCellType(0)
        assert all(self.grid.GetCellType(k) == self.type for k in range(self.count)), path
        self.points = vtk_to_numpy(self.grid.GetPoints().GetData())
        self.cells = vtk_to_numpy(self.grid.GetCells().GetConnectivityArray()).reshape(self.count, -1)

    def data(self, name):
        return vtk_to_numpy(self.grid.GetCellData().GetArray(name))

    def texts(self, name):
        array = self.grid.GetFieldData().GetAbstractArray(name)
        return [array.GetValue(k) for k in range(array.GetNumberOfValues())]

    def shape(self, at):
        """VTK's shape functions at parametric points (in [0, 1]); they depend on the number of nodes only, so the
        first cell speaks for all. [point, node]"""
        values = []
        for point in at:
            values.append([0.0] * self.cells.shape[1])
            self.first_cell().InterpolateFunctions(list(point), values[-1])
        return numpy.array(values)

    def slopes(self, at):
        """Their derivatives by both parameters, quads only: VTK 9.1 has those of a curve in another sequence than its
        functions. [point, node, parameter]"""
        found = []
        for point in at:
            found.append([0.0] * (2 * self.cells.shape[1]))
            self.first_cell().InterpolateDerivs(list(point), found[-1])
        return numpy.array(found).reshape(len(found), -1, 2)

    def first_cell(self):
        cell = self.grid.GetCell(0)
        if hasattr(cell, "SetUniformOrderFromNumPoints"):
            cell.SetUniformOrderFromNumPoints(self.cells.shape[1])
        return cell


def judge_quads(path, cell_type, quads):
    """The positions at the Gauss points, after all else has been compared."""
    grid = Grid(path)
    assert grid.type == cell_type, (path, grid.type)
    assert grid.cells.shape == (len(quads.elems), (quads.order + 1) ** 2), (path, grid.cells.shape)
    at, weights = numpy.polynomial.legendre.leggauss(2 * quads.order + 1)
    square = [((1 + a) / 2, (1 + b) / 2, 0) for b in at for a in at]
    values, slopes = grid.shape(square), grid.slopes(square)
    x = grid.points[grid.cells]
    j = numpy.einsum("gnd,enk->egkd", slopes, x[..., :2])
    dets = j[..., 0, 0] * j[..., 1, 1] - j[..., 0, 1] * j[..., 1, 0]
    assert dets.min() > 0, (path, "det J", dets.min())
    area = float((dets @ numpy.outer(weights, weights).ravel()).sum() / 4)
    assert abs(area / quads.area() - 1) < 1e-12, (path, area, quads.area())
    ours = 4 * quads.jacobian_dets(at).reshape(len(dets), -1)  # VTK's square has sides of 1
    assert numpy.abs(dets / ours - 1).max() < 1e-8, (path, numpy.abs(dets / ours - 1).max())
    assert numpy.array_equal(grid.data("block_id"), quads.block), path
    assert numpy.array_equal(grid.data("element_id"), numpy.arange(len(quads.elems))), path
    assert grid.texts("block_names") == quads.block_names, path
    assert grid.data("least_scaled_jacobian").min() > 0 and grid.data("least_jacobian_bound").min() > 0, path
    return numpy.einsum("gn,enk->egk", values, x), area


def judge_curves(path, cell_type, quads):
    """Lengths by name, where the curves are no interface."""
    grid = Grid(path)
    assert grid.type == cell_type, (path, grid.type)
    at, weights = numpy.polynomial.legendre.leggauss(24)
    points = gll(quads.order)
    x = numpy.einsum("gn,enk->egk", grid.shape([((1 + a) / 2, 0, 0) for a in points]), grid.points[grid.cells])
    speed = numpy.linalg.norm(numpy.einsum("ag,egk->eak", lagrange(points, at)[1], x), axis=2)
    lengths, names, found = speed @ weights, grid.texts("boundary_names"), {}
    for length, name, inside in zip(lengths, grid.data("name_id"), grid.data("is_interface")):
        if not inside:
            found[names[name]] = found.get(names[name], 0) + length
    wanted = quads.group_lengths()
    assert found.keys() == wanted.keys(), (path, found, wanted)
    worst = max(abs(found[name] / wanted[name] - 1) for name in wanted)
    assert worst < 1e-9, (path, worst, found, wanted)


def judge(stage, *paths):
    quads = QuadFile(stage)
    at, _ = numpy.polynomial.legendre.leggauss(2 * quads.order + 1)
    value, _ = lagrange(gll(quads.order), at)
    ours = numpy.einsum("ja,ib,eabk->ejik", value, value, quads.nodes[quads.elems]).reshape(len(quads.elems), -1, 2)
    size = numpy.ptp(quads.nodes, axis=0).max()
    for path, quad_type, curve_type in zip(paths, (70, 77), (68, 75)):
        positions, area = judge_quads(path, quad_type, quads)
        assert numpy.abs(positions[..., 2]).max() == 0, path
        worst = numpy.abs(positions[..., :2] - ours).max() / size
        assert worst < 1e-13, (path, "the map differs by", worst)
        judge_curves(path.replace(".vtu", ".curves.vtu"), curve_type, quads)
        print(f"{path}: area {area:.12g}, the map differs by {worst:.1e}")


vtk.vtkObject.GlobalWarningDisplayOff()  # it warns of degrees that might depend on the direction; they do not
for case in zip(*(iter(sys.argv[1:]),) * 3):
    judge(*case)
