"""Heat conduction from a pipe at 80 degrees through its insulation to the air at 20 degrees, with dolfinx on a mesh of
curved quads; compares the heat loss with the exact one. usage: pipe_heat.py pipe.msh"""
import logging
import math
import sys

import dolfinx
import gmsh
import ufl
from dolfinx import fem
from dolfinx.fem.petsc import LinearProblem
from dolfinx.io import gmshio
from mpi4py import MPI
from petsc4py import PETSc

logging.disable(logging.INFO)  # of the compiler of forms
CONDUCTIVITY = 0.04  # W / (m K)

gmsh.initialize()
gmsh.option.setNumber("General.Verbosity", 1)
gmsh.open(sys.argv[1])
tags = {gmsh.model.getPhysicalName(*group): group[1] for group in gmsh.model.getPhysicalGroups()}
mesh, cells, facets = gmshio.model_to_mesh(gmsh.model, MPI.COMM_WORLD, 0, gdim=2)
gmsh.finalize()

V = fem.FunctionSpace(mesh, ("Lagrange", 3))
on = lambda name: fem.locate_dofs_topological(V, 1, facets.find(tags[name]))
fixed = [fem.dirichletbc(PETSc.ScalarType(value), on(name), V) for name, value in (("pipe", 80), ("outside", 20))]
u, v = ufl.TrialFunction(V), ufl.TestFunction(V)
a = CONDUCTIVITY * ufl.inner(ufl.grad(u), ufl.grad(v)) * ufl.dx
zero = fem.Constant(mesh, PETSc.ScalarType(0)) * v * ufl.dx
temperature = LinearProblem(a, zero, fixed, petsc_options={"ksp_type": "preonly", "pc_type": "lu"}).solve()

# The energy of the solution gives the heat flow with twice the order of accuracy of a boundary integral.
energy = fem.assemble_scalar(fem.form(CONDUCTIVITY * ufl.inner(ufl.grad(temperature), ufl.grad(temperature)) * ufl.dx))
loss = energy / 60
exact = 2 * math.pi * CONDUCTIVITY * 60 / math.acosh((100**2 + 40**2 - 30**2) / (2 * 100 * 40))
print(f"heat loss {loss:.6f} W/m, exact {exact:.6f} W/m, relative error {abs(loss / exact - 1):.1e}")
