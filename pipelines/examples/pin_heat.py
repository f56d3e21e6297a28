"""Heat of a steel pin in a stream of water, with dolfinx on a mesh of two regions: conduction in both, and the water
carries heat away. usage: pin_heat.py pin.msh      the mesh in millimetres, with the groups fluid, pin, inlet, outlet"""
import logging
import sys

import dolfinx
import gmsh
import numpy
import ufl
from dolfinx import fem
from dolfinx.fem.petsc import LinearProblem
from dolfinx.io import gmshio
from mpi4py import MPI
from petsc4py import PETSc

logging.disable(logging.INFO)  # of the compiler of forms
STEEL, WATER = 15e-3, 0.6e-3  # W / (mm K)
CAPACITY = 4.18e-3  # of water, J / (mm^3 K)
SPEED, POWER = 1.0, 0.1  # of the water, mm / s; of the pin, W / mm of its length

gmsh.initialize()
gmsh.option.setNumber("General.Verbosity", 1)
gmsh.open(sys.argv[1])
tags = {gmsh.model.getPhysicalName(*group): group[1] for group in gmsh.model.getPhysicalGroups()}
mesh, cells, facets = gmshio.model_to_mesh(gmsh.model, MPI.COMM_WORLD, 0, gdim=2)
gmsh.finalize()

V = fem.FunctionSpace(mesh, ("Lagrange", 3))
u, v, n = ufl.TrialFunction(V), ufl.TestFunction(V), ufl.FacetNormal(mesh)
dx, ds = ufl.Measure("dx", mesh, subdomain_data=cells), ufl.Measure("ds", mesh, subdomain_data=facets)
on = lambda dim, entities: fem.locate_dofs_topological(V, dim, entities)
solve = lambda a, b, fixed: LinearProblem(a, b, fixed, petsc_options={"ksp_type": "preonly", "pc_type": "lu"}).solve()
zero = fem.Constant(mesh, PETSc.ScalarType(0))
integral = lambda what: fem.assemble_scalar(fem.form(what))

# The flow is that of an ideal fluid: its stream function is SPEED * y on the boundary and constant on the pin.
outer = fem.Function(V)
outer.interpolate(lambda x: SPEED * x[1])
mesh.topology.create_connectivity(1, 2)
fixed = [fem.dirichletbc(outer, on(1, dolfinx.mesh.exterior_facet_indices(mesh.topology))),
         fem.dirichletbc(PETSc.ScalarType(SPEED * 2), on(2, cells.find(tags["pin"])), V)]
stream = solve(ufl.inner(ufl.grad(u), ufl.grad(v)) * dx, zero * v * dx, fixed)
velocity = ufl.as_vector((stream.dx(1), -stream.dx(0)))

# The pin's temperature above that of the water at the inlet.
area = integral(fem.Constant(mesh, 1.0) * dx(tags["pin"]))
a = (STEEL * ufl.inner(ufl.grad(u), ufl.grad(v)) * dx(tags["pin"])
     + (WATER * ufl.inner(ufl.grad(u), ufl.grad(v)) + CAPACITY * ufl.inner(velocity, ufl.grad(u)) * v) * dx(tags["fluid"]))
cold = fem.dirichletbc(PETSc.ScalarType(0), on(1, facets.find(tags["inlet"])), V)
temperature = solve(a, fem.Constant(mesh, POWER / area) * v * dx(tags["pin"]), [cold])
mean = integral(temperature * dx(tags["pin"])) / area
gone = integral(CAPACITY * temperature * ufl.inner(velocity, n) * ds(tags["outlet"]))
print(f"pin {mean:.3f} K, heat that leaves with the water {gone / POWER:.5f} of what the pin gives")
