"""Poisson's equation with a known solution, solved by dolfinx: what tests/benchmarks/poisson and peers share.

-Laplace(u) = f with u = exp(x) sin(y) + sin(2x + y) given on the whole boundary, for coordinates of the size of 1.
Needs the package python3-dolfinx, and with it the distribution's own interpreter."""
import math

QUADRILATERALS = {1: 3, 2: 10, 3: 36}  # types of Gmsh by shape order: those that dolfinx 0.5 knows


def mesh_of(points, cells, order):
    """A mesh from points [n, 2] and elements in Gmsh's sequence of nodes [e, (order + 1)^2]."""
    import numpy
    from dolfinx.cpp.mesh import to_type
    from dolfinx.io import gmshio
    from dolfinx.mesh import create_mesh
    from mpi4py import MPI
    domain = gmshio.ufl_mesh(QUADRILATERALS[order], 2)
    sequence = gmshio.cell_perm_array(to_type(str(domain.ufl_cell())), (order + 1) ** 2)
    used, numbers = numpy.unique(cells, return_inverse=True)
    cells = numbers.reshape(cells.shape)[:, sequence].astype(numpy.int64)
    return create_mesh(MPI.COMM_SELF, cells, points[used], domain)


def solve(mesh, order):
    """The L2 error, the area and the number of unknowns, of Lagrange elements of that order."""
    import dolfinx, numpy, ufl
    from dolfinx import fem
    from dolfinx.fem.petsc import LinearProblem
    space = fem.FunctionSpace(mesh, ("Lagrange", order))
    exact = lambda x, lib: lib.exp(x[0]) * lib.sin(x[1]) + lib.sin(2 * x[0] + x[1])
    given = fem.Function(space)
    given.interpolate(lambda x: exact(x, numpy))
    mesh.topology.create_connectivity(1, 2)
    rim = dolfinx.mesh.exterior_facet_indices(mesh.topology)
    fixed = fem.dirichletbc(given, fem.locate_dofs_topological(space, 1, rim))
    u, v, x = ufl.TrialFunction(space), ufl.TestFunction(space), ufl.SpatialCoordinate(mesh)
    dx = ufl.dx(metadata={"quadrature_degree": 2 * order + 4})
    source = 5 * ufl.sin(2 * x[0] + x[1])  # exp(x) sin(y) is harmonic
    problem = LinearProblem(ufl.inner(ufl.grad(u), ufl.grad(v)) * dx, source * v * dx, bcs=[fixed],
                            petsc_options={"ksp_type": "preonly", "pc_type": "lu"})
    difference = problem.solve() - exact(x, ufl)
    squared, area = (fem.assemble_scalar(fem.form(what)) for what in (difference**2 * dx, fem.Constant(mesh, 1.0) * dx))
    return math.sqrt(squared), area, space.dofmap.index_map.size_global
