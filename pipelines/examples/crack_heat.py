"""Resistance of a cracked plate to a current from left to right, with dolfinx; compares it with that of a long strip
with the same crack. usage: crack_heat.py crack.msh      a mesh of plate_crack.step with the groups left and right"""
import logging
import math
import sys

import gmsh
import ufl
from dolfinx import fem
from dolfinx.fem.petsc import LinearProblem
from dolfinx.io import gmshio
from mpi4py import MPI
from petsc4py import PETSc

logging.disable(logging.INFO)  # of the compiler of forms
LENGTH, WIDTH, DEPTH = 3, 2, 0.9

gmsh.initialize()
gmsh.option.setNumber("General.Verbosity", 1)
gmsh.open(sys.argv[1])
tags = {gmsh.model.getPhysicalName(*group): group[1] for group in gmsh.model.getPhysicalGroups()}
mesh, cells, facets = gmshio.model_to_mesh(gmsh.model, MPI.COMM_WORLD, 0, gdim=2)
gmsh.finalize()

V = fem.FunctionSpace(mesh, ("Lagrange", 3))
on = lambda name: fem.locate_dofs_topological(V, 1, facets.find(tags[name]))
fixed = [fem.dirichletbc(PETSc.ScalarType(value), on(name), V) for name, value in (("left", 0), ("right", 1))]
u, v = ufl.TrialFunction(V), ufl.TestFunction(V)
a = ufl.inner(ufl.grad(u), ufl.grad(v)) * ufl.dx
zero = fem.Constant(mesh, PETSc.ScalarType(0)) * v * ufl.dx
potential = LinearProblem(a, zero, fixed, petsc_options={"ksp_type": "preonly", "pc_type": "lu"}).solve()

# The crack makes a long strip as much longer as this (a conformal map).
longer = -4 / math.pi * WIDTH * math.log(math.cos(math.pi * DEPTH / (2 * WIDTH)))
found = 1 / fem.assemble_scalar(fem.form(ufl.inner(ufl.grad(potential), ufl.grad(potential)) * ufl.dx))
print(f"resistance {found:.4f}, without the crack {LENGTH / WIDTH:.4f}, strip {(LENGTH + longer) / WIDTH:.4f}")
