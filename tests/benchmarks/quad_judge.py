"""Judges meshes of quads against a CAD face: Gmsh reads the file, all else is numpy; shares no code with the tools.

A mesh is accepted if all its elements are quads of one order, it is conforming, covers the face once (loops of the
boundary, Euler's number, area), every det J is proved positive by Bernstein coefficients, the boundary lies within a
tolerance of the CAD curves, and each corner of the face is a vertex. Needs python3-gmsh and python3-numpy."""
import math, pathlib, sys

import gmsh, numpy

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "peers"))
from quad_file import lagrange

SUBDIVISIONS = 8  # of an element, until det J counts as unproved
SAMPLES = 2 * 10 + 1  # of an element in each direction, for the scaled Jacobian


class Refused(Exception):
    """The file holds nothing that could be judged."""


def initialise():
    gmsh.initialize([], False)
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("Geometry.OCCImportLabels", 0)  # Gmsh 4.8 stumbles over those of edges


def tensor_sequence(local, order):
    """Where the nodes of rows j and columns i of an element stand in Gmsh's sequence; None if they are no grid."""
    grid = (numpy.reshape(local, (-1, 2)) + 1) / 2 * order
    whole = numpy.rint(grid).astype(int)
    keys = whole[:, 1] * (order + 1) + whole[:, 0]
    if len(keys) != (order + 1) ** 2 or numpy.abs(grid - whole).max() > 1e-9 or len(set(keys)) != len(keys):
        return None
    return numpy.argsort(keys)


class Mesh:
    """`points` [n, 3], `cells` [e, (order + 1)^2] in Gmsh's sequence, `elems` [e, j, i], `order`, `others`: the number
    of elements that are no complete quads, or of another order than most."""

    def __init__(self, path):
        with open(path, "rb") as file:
            if file.read(1) != b"$":  # Gmsh would run it as a script
                raise Refused("the mesh is no MSH file")
        try:
            gmsh.open(str(path))
        except Exception as failure:
            raise Refused(f"Gmsh cannot read the mesh: {failure}") from failure
        try:
            self.read()
        finally:
            gmsh.model.remove()

    def read(self):
        tags, points, _ = gmsh.model.mesh.getNodes()
        sequence = numpy.argsort(tags)
        tags, self.points = numpy.asarray(tags)[sequence], numpy.reshape(points, (-1, 3))[sequence]
        found, total = {}, 0
        for kind in gmsh.model.mesh.getElementTypes(2):
            name, _, order, count, local, _ = gmsh.model.mesh.getElementProperties(kind)
            nodes = numpy.reshape(gmsh.model.mesh.getElementsByType(kind)[1], (-1, count))
            total += len(nodes)
            grid = tensor_sequence(local, order) if name.startswith("Quad") else None
            if grid is not None and len(nodes):
                cells = numpy.searchsorted(tags, nodes)
                found[order] = cells, cells[:, grid].reshape(-1, order + 1, order + 1)
        if not found:
            raise Refused(f"no quads among {total} elements")
        self.order = max(found, key=lambda order: len(found[order][0]))
        self.cells, self.elems = found[self.order]
        self.others = total - len(self.cells)


def elements_of(path):
    """Number of quads and of other elements."""
    mesh = Mesh(path)
    return len(mesh.cells), mesh.others


def tangents(x, at):
    """Both tangents [e, j, i, 2] and det J [e, j, i] at the points `at` x `at` of elements x [e, j, i, 2]."""
    value, slope = lagrange(numpy.linspace(-1, 1, x.shape[1]), at)
    by_1 = numpy.einsum("ja,ib,eabk->ejik", value, slope, x, optimize=True)
    by_2 = numpy.einsum("ja,ib,eabk->ejik", slope, value, x, optimize=True)
    return by_1, by_2, by_1[..., 0] * by_2[..., 1] - by_1[..., 1] * by_2[..., 0]


def dets(x, at):
    return tangents(x, at)[2]


def bernstein(x):
    """Coefficients of det J, [e, 2 N, 2 N]: of degree 2 N - 1 in both directions, from values at Chebyshev's points."""
    degree = 2 * (x.shape[1] - 1) - 1
    at = -numpy.cos((2 * numpy.arange(degree + 1) + 1) * numpy.pi / (2 * degree + 2))
    k, t = numpy.arange(degree + 1), (1 + at[:, None]) / 2
    basis = numpy.array([math.comb(degree, i) for i in k]) * t**k * (1 - t) ** (degree - k)
    inverse = numpy.linalg.inv(basis)
    return numpy.einsum("aj,bi,eji->eab", inverse, inverse, dets(x, at), optimize=True)


def halves(degree):
    left = numpy.array([[math.comb(k, i) / 2.0**k for i in range(degree + 1)] for k in range(degree + 1)])
    return left, left[::-1, ::-1]


def unproved(x):
    """The elements whose det J is not proved positive. [number]"""
    coefs = bernstein(x)
    owner, noise = numpy.arange(len(x)), 1e-12 * numpy.abs(coefs).max(axis=(1, 2))
    parts, failed = halves(coefs.shape[1] - 1), set()
    for depth in range(SUBDIVISIONS + 1):
        corners = coefs[:, [0, 0, -1, -1], [0, -1, -1, 0]]  # values of det J
        failed |= set(owner[corners.min(axis=1) <= noise[owner]])
        undecided = (coefs.min(axis=(1, 2)) <= noise[owner]) & ~numpy.isin(owner, list(failed))
        owner, coefs = owner[undecided], coefs[undecided]
        if depth == SUBDIVISIONS:
            failed |= set(owner)
        coefs = numpy.concatenate([p @ coefs @ q.T for p in parts for q in parts]) if len(owner) else coefs
        owner = numpy.tile(owner, 4) if len(owner) else owner
    return sorted(failed)


def scaled_jacobian(x):
    """The least of all samples."""
    at, least = numpy.linspace(-1, 1, SAMPLES), math.inf
    for part in numpy.array_split(x, 1 + len(x) // 2000):
        by_1, by_2, det = tangents(part, at)
        product = numpy.linalg.norm(by_1, axis=3) * numpy.linalg.norm(by_2, axis=3)
        least = min(least, float((det / numpy.maximum(product, 1e-300)).min()))
    return least


def resolution(x):
    """The resolution ratio: the integral of (|x_xi|^8 + |x_eta|^8) J over unit squares, over that of as many equal
    squares, which is the squared error of waves of order 3 against theirs; and the square roots of the areas."""
    at, weights = numpy.polynomial.legendre.leggauss(4 * x.shape[1])
    by_1, by_2, det = tangents(x, at)
    mass = numpy.outer(weights, weights) * numpy.abs(det)
    areas = mass.sum(axis=(1, 2))
    powers = sum((2 * numpy.linalg.norm(by, axis=3)) ** 8 for by in (by_1, by_2))
    return float((mass * powers).sum() / (2 * areas.sum() * areas.mean() ** 4)), numpy.sqrt(areas)


def sides_of(elems):
    """[e, side, node]: the four sides counter-clockwise."""
    return numpy.stack([elems[:, 0, :], elems[:, :, -1], elems[:, -1, ::-1], elems[:, ::-1, 0]], axis=1)


def lengths(x):
    """Arc lengths of curves x [..., node, 2]."""
    at, weights = numpy.polynomial.legendre.leggauss(2 * x.shape[-2] + 4)
    _, slope = lagrange(numpy.linspace(-1, 1, x.shape[-2]), at)
    return numpy.linalg.norm(slope @ x, axis=-1) @ weights


class Topology:
    """Edges and vertices of a mesh. `faults`: what is not conforming; `rim`: sides on the boundary [side, node]."""

    def __init__(self, elems):
        self.faults = []
        sides = sides_of(elems)
        sides = sides.reshape(-1, sides.shape[2])
        forward = sides[:, 0] < sides[:, -1]
        keys = numpy.where(forward[:, None], sides, sides[:, ::-1])
        _, first, inverse, counts = numpy.unique(keys, axis=0, return_index=True, return_inverse=True,
                                                 return_counts=True)
        if counts.max() > 2:
            self.faults.append(f"{int((counts > 2).sum())} edges of more than two elements")
        forwards = numpy.bincount(inverse, weights=forward)
        twice = int(((counts == 2) & (forwards != 1)).sum())
        if twice:
            self.faults.append(f"{twice} edges between elements of opposite orientation")
        between = keys[first][:, 1:-1].ravel()
        torn = len(between) - len(numpy.setdiff1d(between, keys[first][:, [0, -1]]))
        if torn:
            self.faults.append(f"{torn} nodes of edges belong to another edge or are vertices too")
        self.rim = sides[first[counts == 1]]
        vertices, quads = numpy.unique(elems[:, [0, 0, -1, -1], [0, -1, -1, 0]], return_counts=True)
        on_rim = numpy.isin(vertices, self.rim[:, [0, -1]])
        self.inner_irregular = int((quads[~on_rim] != 4).sum())
        self.rim_vertices = vertices[on_rim]
        self.euler = len(vertices) - len(counts) + len(elems)
        self.loops = self.count_loops()

    def count_loops(self):
        following = dict(zip(self.rim[:, 0].tolist(), self.rim[:, -1].tolist()))
        if len(following) != len(self.rim) or set(following) != set(following.values()):
            self.faults.append("the boundary is no set of simple closed loops")
            return 0
        loops = 0
        while following:
            start, at = next(iter(following.items()))
            del following[start]
            while at != start:
                at = following.pop(at)
            loops += 1
        return loops


def scale_of(mesh, outline, unit):
    """The factor from the mesh's lengths to those that Gmsh reads: 1 or `unit`, whichever fits."""
    extent = numpy.linalg.norm(numpy.ptp(mesh.points[numpy.unique(mesh.cells)], axis=0))
    wanted = numpy.linalg.norm(outline.high - outline.low)
    return min((1.0, unit), key=lambda factor: abs(math.log(factor * extent / wanted)))


def faults_of_boundary(topology, x, outline, height, tolerance):
    """The distance of the boundary from the CAD curves in diameters, and what is wrong there."""
    at = numpy.linspace(-1, 1, 2 * topology.rim.shape[1] + 1)
    value, _ = lagrange(numpy.linspace(-1, 1, topology.rim.shape[1]), at)
    points = (value @ x[topology.rim]).reshape(-1, 2)
    distance = math.hypot(outline.distances(points).max(), height) / outline.diameter
    faults = [f"the boundary is {distance:.1e} diameters off the curves"] if not distance <= tolerance else []
    vertices, limit = x[topology.rim_vertices], tolerance * outline.diameter
    missing = sum(numpy.linalg.norm(vertices - corner, axis=1).min() > limit for corner in outline.corners)
    if missing:
        faults.append(f"{missing} of {len(outline.corners)} corners are no vertices")
    return distance, faults


def judge(path, outline, unit=1.0, tolerance=1e-4):
    """What is measured, and `faults`: a list of reasons why the mesh is not accepted. `unit`: the factor from lengths
    of the CAD file to those that Gmsh reads; meshes may be in either. `tolerance` and sizes in diameters. Also returns
    ((points [n, 2], cells, order), diameter) for a solver, with coordinates from -1 to 1, or None if the mesh is not
    conforming, valid and of the face's topology: dolfinx ends the program on some that are not."""
    mesh = Mesh(path)
    space = mesh.points * scale_of(mesh, outline, unit)
    x, height = outline.flat(space), numpy.abs(outline.height(space[numpy.unique(mesh.cells)])).max()
    elems = mesh.elems
    gauss, weights = numpy.polynomial.legendre.leggauss(2 * mesh.order)
    area = float(numpy.einsum("eji,j,i->", dets(x[elems], gauss), weights, weights))
    if area < 0:
        elems, area = elems[:, :, ::-1], -area
    topology, faults = Topology(elems), []
    if mesh.others:
        faults.append(f"{mesh.others} elements are no quads of order {mesh.order}")
    bad = unproved(x[elems])
    if bad:
        faults.append(f"{len(bad)} elements are not proved valid")
    faults += topology.faults
    if topology.loops != outline.loops or topology.euler != 2 - outline.loops:
        faults.append(f"{topology.loops} loops and Euler's number {topology.euler} for a face of {outline.loops} loops")
    solvable = not faults
    distance, more = faults_of_boundary(topology, x, outline, height, tolerance)
    faults += more
    if not abs(area - outline.area) <= tolerance * outline.diameter * outline.perimeter:
        faults.append(f"the area is {area / outline.area:.6g} of the face's")
    sides = lengths(x[sides_of(elems)])
    ratio, sizes = resolution(x[elems])
    measured = {
        "quads": len(elems), "irregular_nodes": topology.inner_irregular,
        "scaled_jacobian": scaled_jacobian(x[elems]),
        "edge_ratio": float((sides.max(axis=1) / numpy.maximum(sides.min(axis=1), 1e-300)).max()),
        "resolution_ratio": ratio, "sizes": numpy.quantile(sizes, [1, 0.5, 0]) / outline.diameter,
        "boundary_distance": distance, "faults": faults}
    half = (outline.high - outline.low).max() / 2
    scaled = (x - (outline.low + outline.high) / 2) / half
    return measured, ((scaled, mesh.cells, mesh.order), outline.diameter / half) if solvable else None
