"""Reads our MSH files with dolfinx, of the orders 1 to 3 that it knows; area and named lengths against the CAD model.

usage: judge_dolfinx.py LIMIT {SHAPE.step FILE.msh ORDER}...      exit 1 where a relative error exceeds LIMIT

The CAD model is measured by OpenCASCADE, through Gmsh. Its edges are told apart by place: an edge of the model goes
with the names whose edges of the mesh are nearest to points in its inside; names that share an edge of the model, and
edges that share a name, are measured together. The mesh lies in the model's own space (--frame 3d).
"""
import logging, sys

logging.disable(logging.INFO)

import dolfinx, gmsh, numpy, ufl
from dolfinx import fem
from dolfinx.io import gmshio
from mpi4py import MPI


def along(edge, low, high):
    """Points, derivatives and weights of Gauss's rule on 256 pieces; occ.getMass is off by 1e-3 on some curves."""
    at, weights = numpy.polynomial.legendre.leggauss(8)
    step = (high - low) / 256
    at = (low + step * (numpy.arange(256)[:, None] + (1 + at) / 2)).ravel()
    values = (numpy.reshape(get(1, edge, at), (-1, 3)) for get in (gmsh.model.getValue, gmsh.model.getDerivative))
    return *values, numpy.tile(weights, 256) * step / 2


def cad(path):
    """Area, and for each edge its length and points in its inside."""
    gmsh.model.add("cad")
    gmsh.model.occ.importShapes(path)
    gmsh.model.occ.synchronize()
    (face,) = gmsh.model.getEntities(2)
    loops, edges = [], []  # a loop: its vector of area, its points
    for _, signed in gmsh.model.getBoundary([face], oriented=True):
        tag, sign = abs(signed), 1 if signed > 0 else -1
        (low,), (high,) = gmsh.model.getParametrizationBounds(1, tag)
        x, slope, weights = along(tag, low, high)
        merged = [sign * weights @ numpy.cross(x, slope) / 2]  # Green, as a vector: any plane
        merged.append({end for _, end in gmsh.model.getBoundary([(1, tag)], oriented=False)})
        for loop in [loop for loop in loops if loop[1] & merged[1]]:
            merged = [merged[0] + loop[0], merged[1] | loop[1]]
        loops = [loop for loop in loops if not loop[1] & merged[1]] + [merged]
        inside = numpy.linspace(0.02, 0.98, 33)
        points = numpy.reshape(gmsh.model.getValue(1, tag, low + (high - low) * inside), (-1, 3))
        edges.append((numpy.linalg.norm(slope, axis=1) @ weights, points))
    gmsh.model.remove()
    areas = sorted(numpy.linalg.norm(area) for area, _ in loops)
    return areas[-1] - sum(areas[:-1]), edges


def read(path):
    """Mesh, tags of its boundary, names by tag, and the inner points of the boundary's edges by tag."""
    gmsh.open(path)
    names = {tag: gmsh.model.getPhysicalName(1, tag) for dim, tag in gmsh.model.getPhysicalGroups(1)}
    inside = {}
    for tag in names:
        points = []
        for entity in gmsh.model.getEntitiesForPhysicalGroup(1, tag):
            for kind, _, nodes in zip(*gmsh.model.mesh.getElements(1, entity)):
                _, _, order, count, *_ = gmsh.model.mesh.getElementProperties(kind)
                for line in nodes.reshape(-1, count):
                    x = numpy.array([gmsh.model.mesh.getNode(node)[0] for node in line])
                    points += [x[:2].mean(axis=0)] if order == 1 else list(x[2:])
        inside[tag] = numpy.array(points)
    mesh, _, facets = gmshio.model_to_mesh(gmsh.model, MPI.COMM_SELF, 0, gdim=3)
    gmsh.model.remove()
    return mesh, facets, names, inside


def components(edges, inside):
    """Sets of CAD edges and of tags that belong together: ([edge, ...], [tag, ...])."""
    tags, points = zip(*inside.items())
    owner = numpy.repeat(tags, [len(p) for p in points])
    points = numpy.concatenate(points)
    groups = []
    for number, (_, on_edge) in enumerate(edges):
        nearest = ((on_edge[:, None] - points[None]) ** 2).sum(axis=2).argmin(axis=1)
        found, counts = numpy.unique(owner[nearest], return_counts=True)
        merged = {number}, set(found[counts > 3])  # points near a joint may go astray
        for group in [g for g in groups if g[1] & merged[1]]:
            merged = merged[0] | group[0], merged[1] | group[1]
            groups.remove(group)
        groups.append(merged)
    return groups


def judge(cad_path, msh_path, order):
    """The relative errors of the area and of the worst length."""
    wanted_area, edges = cad(cad_path)
    mesh, facets, names, inside = read(msh_path)
    assert mesh.ufl_domain().ufl_coordinate_element().degree() == order, (msh_path, order)
    one = fem.Constant(mesh, 1.0)
    area = fem.assemble_scalar(fem.form(one * ufl.dx(metadata={"quadrature_degree": 4 * order})))
    groups, errors = components(edges, inside), []
    assert set().union(*(tags for _, tags in groups)) == set(names), (msh_path, groups, names)
    for numbers, tags in groups:
        chosen = numpy.sort(facets.indices[numpy.isin(facets.values, list(tags))])
        marked = dolfinx.mesh.meshtags(mesh, 1, chosen, numpy.ones(len(chosen), dtype=numpy.int32))
        rim = ufl.ds(domain=mesh, subdomain_data=marked, metadata={"quadrature_degree": 16})
        found = fem.assemble_scalar(fem.form(one * rim(1)))
        errors.append(abs(found / sum(edges[k][0] for k in numbers) - 1))
    return abs(area / wanted_area - 1), max(errors)


def main():
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("Geometry.OCCImportLabels", 0)  # Gmsh 4.8 stumbles over those of edges
    limit, cases = float(sys.argv[1]), list(zip(*(iter(sys.argv[2:]),) * 3))
    assert cases
    worst = 0
    for cad_path, msh_path, order in cases:
        area, length = judge(cad_path, msh_path, int(order))
        worst = max(worst, area, length)
        print(f"{msh_path}: area {area:.1e}, lengths {length:.1e}", "" if max(area, length) <= limit else "TOO FAR OFF")
    sys.exit(not worst <= limit)


main()
