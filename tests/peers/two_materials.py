"""Conduction in a disc of radius 0.4 and the square around it, of conductivities 10 and 1, solved by dolfinx on our
meshes: the error in L2 against the mesh.

usage: two_materials.py ORDER FILE.msh...      prints for each file quads, error, rate and the error of the interface

-div(k grad(u)) = f; k is that of the group "fibre" or "matrix" of each element. u = e + (r^2 - 0.4^2) exp(x) cos(y) / k,
where e is the field of a cylinder in a uniform one: x 2 / (k + 1) inside, x - x 0.4^2 (k - 1) / (k + 1) / r^2 outside
with k = 10. u and k du/dn are continuous across the circle; the gradient of u is not. `rate` is log(error before /
error) / log(h before / h) with h = sqrt(area / quads). The last figure is the relative error of the length of the group
"matrix-fibre".
"""
import logging, math, sys

import dolfinx, gmsh, numpy, ufl
from dolfinx import fem
from dolfinx.fem.petsc import LinearProblem
from dolfinx.io import gmshio
from mpi4py import MPI

RADIUS, CONDUCTIVITY = 0.4, {"matrix": 1.0, "fibre": 10.0}


def load(path):
    """The mesh, its material groups and its named edges, and the tag of each name."""
    gmsh.open(path)
    tags = {gmsh.model.getPhysicalName(*group): group[1] for group in gmsh.model.getPhysicalGroups()}
    mesh, cells, facets = gmshio.model_to_mesh(gmsh.model, MPI.COMM_SELF, 0, gdim=2)
    return mesh, cells, facets, tags


def exact(x, k, lib):
    """For the material of conductivity k; either formula is smooth near the circle, so they need no exact interface."""
    ratio, r2 = CONDUCTIVITY["fibre"], x[0] ** 2 + x[1] ** 2
    inside, outside = x[0] * 2 / (ratio + 1), lambda: x[0] - x[0] * RADIUS**2 * (ratio - 1) / (ratio + 1) / r2
    return (inside if k == ratio else outside()) + (r2 - RADIUS**2) * lib.exp(x[0]) * lib.cos(x[1]) / k


def solve(mesh, cells, facets, tags, order):
    """The L2 error and the relative error of the interface's length."""
    space, where = fem.FunctionSpace(mesh, ("Lagrange", order)), fem.FunctionSpace(mesh, ("DG", 0))
    k = fem.Function(where)
    for name, value in CONDUCTIVITY.items():
        k.x.array[cells.find(tags[name])] = value  # one unknown of order 0 for each cell, numbered alike
    given = fem.Function(space)
    given.interpolate(lambda x: exact(x, CONDUCTIVITY["matrix"], numpy), cells.find(tags["matrix"]))
    mesh.topology.create_connectivity(1, 2)
    rim = dolfinx.mesh.exterior_facet_indices(mesh.topology)
    fixed = fem.dirichletbc(given, fem.locate_dofs_topological(space, 1, rim))
    u, v, x = ufl.TrialFunction(space), ufl.TestFunction(space), ufl.SpatialCoordinate(mesh)
    rule = {"quadrature_degree": 2 * order + 4}
    dx = ufl.Measure("dx", domain=mesh, subdomain_data=cells, metadata=rule)
    growth = ufl.exp(x[0]) * ufl.cos(x[1])  # harmonic
    source = -4 * growth - 4 * ufl.exp(x[0]) * (x[0] * ufl.cos(x[1]) - x[1] * ufl.sin(x[1]))
    found = LinearProblem(k * ufl.inner(ufl.grad(u), ufl.grad(v)) * dx, source * v * dx, bcs=[fixed],
                          petsc_options={"ksp_type": "preonly", "pc_type": "lu"}).solve()
    squared = sum(fem.assemble_scalar(fem.form((found - exact(x, value, ufl)) ** 2 * dx(tags[name])))
                  for name, value in CONDUCTIVITY.items())
    inner = ufl.Measure("dS", domain=mesh, subdomain_data=facets, metadata=rule)
    length = fem.assemble_scalar(fem.form(fem.Constant(mesh, 1.0) * inner(tags["matrix-fibre"])))
    return math.sqrt(squared), abs(length / (2 * math.pi * RADIUS) - 1)


def main():
    logging.disable(logging.INFO)
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    order, before = int(sys.argv[1]), None
    for path in sys.argv[2:]:
        mesh, cells, facets, tags = load(path)
        assert mesh.ufl_domain().ufl_coordinate_element().degree() == order
        error, length = solve(mesh, cells, facets, tags, order)
        quads = len(cells.values)
        rate = math.log(before[0] / error) / math.log(quads / before[1]) * 2 if before else None
        print(quads, f"{error:.2e}", f"{rate:.2f}" if before else "-", f"{length:.1e}")
        before = error, quads


main()
