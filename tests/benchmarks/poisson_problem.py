"""Poisson's equation with known solutions, solved by dolfinx: what tests/benchmarks/poisson and peers share.

-Laplace(u) = f with u given on the whole boundary, for coordinates of the size of 1. Needs the package python3-dolfinx,
and with it the distribution's own interpreter."""
import math

QUADRILATERALS = {1: 3, 2: 10, 3: 36}  # types of Gmsh by shape order: those that dolfinx 0.5 knows
WAVES, CHOICES = 8, 4  # waves of a sum, and wave lengths across the diameter; sums of which the mean counts


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


def smooth(x, lib, _):
    """u = exp(x) sin(y) + sin(2x + y), and f."""
    bent = lib.sin(2 * x[0] + x[1])
    return lib.exp(x[0]) * lib.sin(x[1]) + bent, 5 * bent  # exp(x) sin(y) is harmonic


def waves(x, lib, terms):
    """u = sum of sin(k_x x + k_y y + phase) / 2 over the rows (k_x, k_y, phase) of `terms`, all |k| equal, and f."""
    u = sum(lib.sin(terms[i, 0] * x[0] + terms[i, 1] * x[1] + terms[i, 2]) for i in range(WAVES)) / 2
    return u, (terms[0, 0] ** 2 + terms[0, 1] ** 2) * u


def choices_of_waves(diameter):
    """Terms of `waves` in directions that are evenly spaced over half a turn; the first one and the phases by chance,
    the same for all meshes."""
    import numpy
    random, k = numpy.random.default_rng(1), 2 * math.pi * WAVES / diameter
    for _ in range(CHOICES):
        angles = random.uniform(0, math.pi) + numpy.arange(WAVES) * math.pi / WAVES
        yield numpy.stack([k * numpy.cos(angles), k * numpy.sin(angles), random.uniform(0, 2 * math.pi, WAVES)], axis=1)


def solve(mesh, order, solution=smooth, terms=0.0):
    """The L2 error, the area and the number of unknowns, of Lagrange elements of that order."""
    import dolfinx, numpy, ufl
    from dolfinx import fem
    from dolfinx.fem.petsc import LinearProblem
    space = fem.FunctionSpace(mesh, ("Lagrange", order))
    given = fem.Function(space)
    given.interpolate(lambda x: solution(x, numpy, terms)[0])
    mesh.topology.create_connectivity(1, 2)
    rim = dolfinx.mesh.exterior_facet_indices(mesh.topology)
    fixed = fem.dirichletbc(given, fem.locate_dofs_topological(space, 1, rim))
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    exact, source = solution(ufl.SpatialCoordinate(mesh), ufl, fem.Constant(mesh, terms))  # compiled once for all terms
    dx = ufl.dx(metadata={"quadrature_degree": 2 * order + 8})
    problem = LinearProblem(ufl.inner(ufl.grad(u), ufl.grad(v)) * dx, source * v * dx, bcs=[fixed])
    problem.solver.setType("preonly")  # not by petsc_options, of which a program can set 512
    problem.solver.getPC().setType("lu")
    difference = problem.solve() - exact
    squared, area = (fem.assemble_scalar(fem.form(what)) for what in (difference**2 * dx, fem.Constant(mesh, 1.0) * dx))
    return math.sqrt(squared), area, space.dofmap.index_map.size_global


def errors(mesh, order, diameter):
    """The errors of `smooth` and of `waves`, and the number of unknowns."""
    from petsc4py import PETSc
    error, _, unknowns = solve(mesh, order)
    squares = [solve(mesh, order, waves, terms)[0] ** 2 for terms in choices_of_waves(diameter)]
    PETSc.garbage_cleanup(mesh.comm)  # of factors, which otherwise stay in memory until the end
    return error, math.sqrt(sum(squares) / CHOICES), unknowns
