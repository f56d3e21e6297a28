"""Reads our MSH files with Gmsh: det J of every element by Gmsh's shape functions, the elements of every name with
their measure, and the same in both versions of the format.

usage: judge_gmsh_shapes.py {X.quad.h5|X.hex.h5 FILE.msh FILE.22.msh}...
"""
import sys
from functools import cache

import gmsh, numpy

from stage_measures import differences, measures, rule


@cache
def slopes(kind, dim):
    """Derivatives of Gmsh's shape functions at rule(dim): [point, node, direction]."""
    points, _ = rule(dim)
    at = numpy.zeros((len(points), 3))
    at[:, :dim] = points
    _, values, _ = gmsh.model.mesh.getBasisFunctions(kind, at.ravel(), "GradLagrange")
    return values.reshape(len(points), -1, 3)[..., :dim]


def load(path):
    """Elements by name, (dimension, name) -> [(type, numbers, nodes)], and nodes, of a file that Gmsh reads silently.
    """
    gmsh.clear()
    gmsh.logger.start()
    gmsh.open(path)
    complaints = [line for line in gmsh.logger.get() if not line.startswith(("Info", "Progress"))]
    gmsh.logger.stop()
    assert not complaints, (path, complaints)
    numbers, positions, _ = gmsh.model.mesh.getNodes()
    order, content = numpy.argsort(numbers), {}
    assert numpy.array_equal(numbers[order], numpy.arange(1, len(numbers) + 1)), path
    for dim, tag in gmsh.model.getPhysicalGroups():
        elements = [gmsh.model.mesh.getElements(dim, one) for one in gmsh.model.getEntitiesForPhysicalGroup(dim, tag)]
        content[dim, gmsh.model.getPhysicalName(dim, tag)] = sorted(
            (kind, tuple(number), tuple(nodes)) for (kind,), (number,), (nodes,) in elements)
    return content, positions.reshape(-1, 3)[order]


def dets_of(kind, nodes, positions, dim):
    """det J [element, point]; of lines, and of sides of hexahedra, the stretch."""
    slope = slopes(kind, dim)
    x = positions[numpy.array(nodes, dtype=int).reshape(-1, slope.shape[1]) - 1]
    columns = numpy.einsum("pnd,ena->depa", slope, x)
    if dim == 3:
        return numpy.einsum("epa,epa->ep", columns[0], numpy.cross(columns[1], columns[2]))
    across = numpy.cross(*columns) if dim == 2 else columns[0]
    flat = dim == 2 and not positions[:, 2].any()
    return across[..., 2] if flat else numpy.linalg.norm(across, axis=-1)


def judge(stage, msh, msh22):
    wanted, (content, positions), dets, groups = measures(stage), load(msh), {}, {}
    for key, pieces in content.items():
        count, size = 0, 0.0
        for kind, numbers, nodes in pieces:
            found = dets_of(kind, nodes, positions, key[0])
            count, size = count + len(numbers), size + float((found @ rule(key[0])[1]).sum())
            if key[0] == wanted.dimension:
                dets.update(zip(numbers, found))
        groups[key] = count, size
    # As Gmsh has its polynomials from monomials: at equispaced nodes their condition number, 5e3 at order 9 along a
    # line, is 1e11 in a hexahedron.
    tolerance = max(1e-9, 1e-13 * 10**wanted.order)
    said = differences(groups, wanted.groups, tolerance)
    assert not said, (msh, said)
    dets = numpy.array([dets[number] for number in sorted(dets)])
    assert dets.shape == wanted.dets.shape and dets.min() > 0, (msh, dets.shape, dets.min())
    off = numpy.abs(dets / wanted.dets[wanted.sequence] - 1).max()
    assert off < tolerance, (msh, "det J differs by", off)
    other = load(msh22)
    assert content == other[0], (msh22, "other groups than in", msh)
    assert numpy.array_equal(positions, other[1]), (msh22, "other nodes than in", msh)


gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
for case in zip(*(iter(sys.argv[1:]),) * 3):
    judge(*case)
print(f"{len(sys.argv[1:]) // 3} meshes")
