"""A solution that jumps across a shock before a cylinder, with dolfinx on a mesh of curved quads, in place of a flow; and
the metric by which the next mesh has about as many quads as are asked for, from its second derivatives.
usage: shock_metric.py MESH.msh METRIC.csv QUADS"""
import logging
import math
import sys

import dolfinx
import gmsh
import numpy as np
import ufl
from dolfinx import fem
from dolfinx.fem.petsc import LinearProblem
from dolfinx.io import gmshio
from mpi4py import MPI

logging.disable(logging.INFO)  # of the compiler of forms
path, metric_path, quads = sys.argv[1], sys.argv[2], float(sys.argv[3])
ORDER, WIDTH, LONGEST, SHORTEST = 2, 0.06, 0.4, 0.01  # lengths in millimetres


def jump(x, lib):
    """tanh(d / WIDTH), d the distance from the shock, and minus its Laplacian."""
    radius = lib.sqrt((x[0] - 0.25) ** 2 + x[1] ** 2)
    u = lib.tanh((radius - 1.15) / WIDTH)
    return u, (1 - u**2) * (2 * u / WIDTH**2 - 1 / (radius * WIDTH))


def solved(a, right, fixed=()):
    return LinearProblem(a, right, fixed, petsc_options={"ksp_type": "preonly", "pc_type": "lu"}).solve()


def projected(what, space):
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    return solved(ufl.inner(u, v) * ufl.dx, ufl.inner(what, v) * ufl.dx)


gmsh.initialize()
gmsh.option.setNumber("General.Verbosity", 1)
gmsh.open(path)
mesh, _, _ = gmshio.model_to_mesh(gmsh.model, MPI.COMM_WORLD, 0, gdim=2)
gmsh.finalize()

V = fem.FunctionSpace(mesh, ("Lagrange", ORDER))
exact, source = jump(ufl.SpatialCoordinate(mesh), ufl)
given = fem.Function(V)
given.interpolate(lambda x: jump(x, np)[0])
mesh.topology.create_connectivity(1, 2)
rim = fem.locate_dofs_topological(V, 1, dolfinx.mesh.exterior_facet_indices(mesh.topology))
u, v = ufl.TrialFunction(V), ufl.TestFunction(V)
dx = ufl.dx(metadata={"quadrature_degree": 10})
solution = solved(ufl.inner(ufl.grad(u), ufl.grad(v)) * dx, source * v * dx, [fem.dirichletbc(given, rim)])
error = math.sqrt(fem.assemble_scalar(fem.form((solution - exact) ** 2 * dx)))

# The second derivatives at the vertices, by two projections; their absolute values are a metric up to a factor.
slopes = projected(ufl.grad(solution), fem.VectorFunctionSpace(mesh, ("Lagrange", 1)))
linear = fem.FunctionSpace(mesh, ("Lagrange", 1))
xx, xy, yy = (projected(slopes[i].dx(j), linear).x.array for i, j in ((0, 0), (0, 1), (1, 1)))
values, vectors = np.linalg.eigh(np.stack([np.stack([xx, xy], axis=1), np.stack([xy, yy], axis=1)], axis=1))
parts = fem.petsc.assemble_vector(fem.form(ufl.TestFunction(linear) * ufl.dx)).array  # of the area, by vertex

low, high = -20.0, 20.0  # logarithms of the factor, which is halved until the metric has so many unit squares
for _ in range(60):
    factor = math.exp((low + high) / 2)
    eigen = np.clip(factor * abs(values), 1 / LONGEST**2, 1 / SHORTEST**2)
    low, high = ((low + high) / 2, high) if (parts * np.sqrt(eigen.prod(axis=1))).sum() < quads else (low, (low + high) / 2)
tensors = (vectors * eigen[:, None, :]) @ vectors.transpose(0, 2, 1)
table = np.column_stack([linear.tabulate_dof_coordinates()[:, :2], tensors[:, 0, 0], tensors[:, 0, 1], tensors[:, 1, 1]])
np.savetxt(metric_path, table, delimiter=",", header="x,y,m11,m12,m22", comments="")
cells = mesh.topology.index_map(2).size_global
print(f"{cells} quads, error {error:.1e}")
