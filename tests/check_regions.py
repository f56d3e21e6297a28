#!/usr/bin/env python3
"""Checks a quad mesh of several regions: areas, interfaces, cracks, periodic sides.

    check_regions.py x.quad.h5 [--face y.h5] [--area-tolerance 1e-10] ...

Reads x.quad.h5 with h5py and computes with numpy; no code of the tools is used. The face is the one in the mesh or,
with --face, that of another stage file (x.tri.h5), which must have the same curves. One line for each check, "ok" or
"FAULT", with the figure; then the places of the first faults. Exit code 0: all hold, 1: a fault, 3: a file cannot be
read.

What is checked
  areas          of each region: Gauss quadrature of Green's formula on its NURBS curves against that of det J on its
                 elements, relative to the region's area. Elements of order N are polynomials: the deviation falls with
                 their size and order, and is printed.
  conformity     each side of an element belongs to two elements with the same nodes, or is a boundary edge; no two
                 nodes lie in one place but those of open interfaces; interface edges are there from both sides, on
                 curves that are partners; edges follow the loops of the face
  interfaces     nodes of interface edges lie on their CAD curve
  boundary       nodes of boundary edges lie on their CAD curves
  regions        elements that are connected but for interfaces are of one region, in which they lie; no block has
                 elements on both sides of an interface
  cracks         open embedded curves: nodes of both sides at the same places, doubled but for the tips. Open
                 interfaces of two regions need not conform: their nodes are counted
  periodic       nodes of periodic curves are mapped onto each other
"""
import argparse
import sys

import h5py
import numpy as np

MOST_PLACES = 5


# ---------------------------------------------------------------------------------------------------------- reading


def text(values):
    return [v.decode() if isinstance(v, bytes) else str(v) for v in values]


class Curve:
    """A clamped rational B-spline."""

    def __init__(self, degree, knots, poles, weights):
        self.degree, self.knots = int(degree), knots
        self.homogeneous = np.column_stack([poles * weights[:, None], weights])
        self.begin, self.end = knots[0], knots[-1]
        self.spans = [(a, b) for a, b in zip(knots[:-1], knots[1:]) if a < b]

    def _basis(self, t, degree):
        """[len(t), number of functions of this degree on the curve's knots], by Cox and de Boor."""
        k = self.knots
        last = max(i for i in range(len(k) - 1) if k[i] < k[i + 1])
        span = np.clip(np.searchsorted(k, t, side="right") - 1, 0, last)
        basis = np.zeros((len(t), len(k) - 1))
        basis[np.arange(len(t)), span] = 1
        for p in range(1, degree + 1):
            count = len(k) - 1 - p
            lower = np.where(k[p:p + count] > k[:count], k[p:p + count] - k[:count], np.inf)
            upper = np.where(k[p + 1:p + 1 + count] > k[1:1 + count], k[p + 1:p + 1 + count] - k[1:1 + count], np.inf)
            basis = ((t[:, None] - k[:count]) / lower * basis[:, :count]
                     + (k[p + 1:p + 1 + count] - t[:, None]) / upper * basis[:, 1:count + 1])
        return basis

    def at(self, t):
        """Points and first derivatives [len(t), dimension]."""
        t = np.atleast_1d(np.asarray(t, float))
        p, k, h = self.degree, self.knots, self.homogeneous
        x = self._basis(t, p) @ h
        width = (k[p + 1:p + len(h)] - k[1:len(h)])[:, None]
        slopes = p * (h[1:] - h[:-1]) / np.where(width > 0, width, np.inf)
        inner = Curve.__new__(Curve)
        inner.knots = k[1:-1]
        dx = inner._basis(t, p - 1) @ slopes
        points = x[:, :-1] / x[:, -1:]
        return points, (dx[:, :-1] - points * dx[:, -1:]) / x[:, -1:]

    def distances(self, points):
        """From each point to the curve: Newton's method on the squared distance from the best of many samples."""
        samples = np.unique(np.concatenate([np.linspace(a, b, 33) for a, b in self.spans]))
        on_curve = self.at(samples)[0]
        best = np.full(len(points), np.inf)
        order = np.argsort(((points[:, None, :] - on_curve[None]) ** 2).sum(axis=2), axis=1)[:, :3]
        for start in order.T:
            t = samples[start]
            low = samples[np.maximum(start - 1, 0)]
            high = samples[np.minimum(start + 1, len(samples) - 1)]
            for _ in range(60):
                x, dx = self.at(t)
                slope = ((x - points) * dx).sum(axis=1)
                low, high = np.where(slope < 0, t, low), np.where(slope < 0, high, t)
                step = t - slope / np.maximum((dx ** 2).sum(axis=1), 1e-300)
                t = np.where((step > low) & (step < high), step, (low + high) / 2)
            for u in (t, low, high):
                best = np.minimum(best, np.linalg.norm(self.at(u)[0] - points, axis=1))
        return best


class Face:
    def __init__(self, file):
        group = file["face"] if "face" in file else file["mesh/face"]
        offsets = lambda name: group[f"curves/{name}_offsets"][:]
        parts = lambda name: np.split(group[f"curves/{name}"][:], offsets(name)[1:-1])
        self.curves = [Curve(*c) for c in zip(group["curves/degree"][:], parts("knots"), parts("poles"), parts("weights"))]
        n = len(self.curves)
        self.names = text(group["curve_names"][:])
        self.loops = group["loop_offsets"][:]
        self.diameter = float(group["diameter"][()])
        self.origin = group["origin"][:]
        num_loops = len(self.loops) - 1
        self.region_loops = group["region_loops"][:] if "region_loops" in group else np.array([0, num_loops])
        self.num_regions = len(self.region_loops) - 1
        self.region_names = text(group["region_names"][:]) if "region_names" in group else ["the face"]
        self.partners = group["partners"][:] if "partners" in group else np.full(n, -1)
        self.loop_of = np.repeat(np.arange(num_loops), np.diff(self.loops))
        region_of_loop = np.repeat(np.arange(self.num_regions), np.diff(self.region_loops))
        self.region_of = region_of_loop[self.loop_of]
        self.pairs = []
        if "periodic_pairs" in group:
            pairs = group["periodic_pairs"]
            self.pairs = list(zip(pairs["curves"][:], pairs["angle"][:], pairs["shift"][:]))

    def next(self, curve):
        loop = self.loop_of[curve]
        return curve + 1 if curve + 1 < self.loops[loop + 1] else self.loops[loop]

    def previous(self, curve):
        loop = self.loop_of[curve]
        return curve - 1 if curve > self.loops[loop] else self.loops[loop + 1] - 1

    def area(self, region, num_points, pieces):
        """Green's formula, relative to a point of the outline against cancellation."""
        at, weights = np.polynomial.legendre.leggauss(num_points)
        curves = np.flatnonzero(self.region_of == region)
        origin = self.curves[curves[0]].at(self.curves[curves[0]].begin)[0][0]
        total = 0.0
        for c in curves:
            for a, b in self.curves[c].spans:
                ends = np.linspace(a, b, pieces + 1)
                for low, high in zip(ends[:-1], ends[1:]):
                    x, dx = self.curves[c].at((low + high) / 2 + (high - low) / 2 * at)
                    x = x - origin
                    total += (high - low) / 4 * weights @ (x[:, 0] * dx[:, 1] - x[:, 1] * dx[:, 0])
        return total

    def winding(self, region, point):
        """Turns of the region's boundary about a point: 1 inside, 0 outside."""
        return round(sum(self.swept(self.curves[c], *s, point, 0) for c in np.flatnonzero(self.region_of == region)
                         for s in self.curves[c].spans) / (2 * np.pi))

    def swept(self, curve, a, b, point, depth):
        """The angle that a part of a curve sweeps about a point: halved until many points of it turn little."""
        x = curve.at(np.linspace(a, b, 9))[0] - point
        z = x[:, 0] + 1j * x[:, 1]
        if depth == 40 or np.min(np.abs(z)) == 0:
            return 0.0
        turns = np.angle(z[1:] / z[:-1])
        if np.max(np.abs(turns)) < 0.3:
            return float(np.sum(turns))
        middle = (a + b) / 2
        return self.swept(curve, a, middle, point, depth + 1) + self.swept(curve, middle, b, point, depth + 1)


class Mesh:
    def __init__(self, file):
        self.order = int(file["order"][()])
        width = self.order + 1
        self.nodes = file["nodes"][:]
        self.elems = file["elem_nodes"][:].reshape(-1, width, width)  # [element, j, i]
        self.block = file["elem_block"][:]
        names = text(file["block_names"][:])
        regions = file["block_region"][:] if "block_region" in file else np.zeros(len(names), int)
        self.region = regions[self.block]
        self.boundary = self.edges(file, "boundary_edges")
        self.interface = self.edges(file, "interface_edges")

    @staticmethod
    def edges(file, name):
        """[number, (element, side, curve)]"""
        if name not in file or int(file[name].attrs.get("count", [1])[0]) == 0:
            return np.zeros((0, 3), int)
        return np.column_stack([file[f"{name}/{key}"][:] for key in ("elem", "side", "curve")])

    def side(self, elem, side):
        """The nodes of a side, counter-clockwise."""
        e = self.elems[elem]
        return [e[0, :], e[:, -1], e[-1, ::-1], e[::-1, 0]][side]

    def areas(self):
        """Of each element, exactly: det J is a polynomial."""
        width = self.order + 1
        nodes = np.sort(np.concatenate([[-1, 1], np.polynomial.legendre.Legendre.basis(self.order).deriv().roots().real]))
        at, weights = np.polynomial.legendre.leggauss(width + 1)
        legendre = np.polynomial.legendre
        coefficients = np.linalg.inv(legendre.legvander(nodes, self.order))
        value = legendre.legvander(at, self.order) @ coefficients
        slope = legendre.legvander(at, max(self.order - 1, 0)) @ legendre.legder(coefficients)
        areas = []
        for part in np.array_split(self.elems, 1 + len(self.elems) // 2000):
            x = self.nodes[part]
            x = x - x[:, :1, :1]
            a = np.einsum("ja,ib,eabk->ejik", value, slope, x)
            b = np.einsum("ja,ib,eabk->ejik", slope, value, x)
            areas.append(np.einsum("eji,j,i->e", a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0], weights, weights))
        return np.concatenate(areas)


# ----------------------------------------------------------------------------------------------------------- checks


class Results:
    def __init__(self, face):
        self.face, self.num_faults = face, 0

    def say(self, what, is_ok, figure, places=()):
        """One line, and where the first faults are."""
        self.num_faults += not is_ok
        print(f"{'ok   ' if is_ok else 'FAULT'} {what}: {figure}")
        for place in list(places)[:MOST_PLACES]:
            print(f"      {place}")
        if len(places) > MOST_PLACES:
            print(f"      and {len(places) - MOST_PLACES} more")

    def at(self, x):
        x = np.asarray(x) + self.face.origin
        return f"at ({x[0]:.9g}, {x[1]:.9g})"


def exact_area(face, region):
    area, points = face.area(region, 20, 1), 1
    while points < 64:
        points *= 2
        finer = face.area(region, 20, points)
        if abs(finer - area) <= 1e-14 * abs(finer):
            return finer
        area = finer
    return area


def check_areas(face, mesh, results, tolerance):
    areas = mesh.areas()
    for region in range(face.num_regions):
        exact, found = exact_area(face, region), areas[mesh.region == region].sum()
        deviation = abs(found - exact) / abs(exact)
        results.say(f"area of region {region} ({face.region_names[region]})", deviation <= tolerance,
                    f"{found:.15g}, of its curves {exact:.15g}, relative deviation {deviation:.2e} "
                    f"(at most {tolerance:.0e}) at order {mesh.order}, {np.count_nonzero(mesh.region == region)} quads")


def check_sides(mesh, results):
    """Returns the neighbour of each side, or -1: [element, side]."""
    known, neighbour, faults = {}, np.full((len(mesh.elems), 4), -1), []
    for elem in range(len(mesh.elems)):
        for side in range(4):
            nodes = tuple(mesh.side(elem, side))
            other = known.pop(nodes[::-1], None)
            if other is None:
                if nodes in known:
                    faults.append(f"side {side} of element {elem} is a side of element {known[nodes][0]} in the same "
                                  f"direction, {results.at(mesh.nodes[nodes[0]])}")
                known[nodes] = elem, side
            else:
                neighbour[elem, side], neighbour[other] = other[0], elem
    outer = {place: nodes for nodes, place in known.items()}
    named = {(int(e), int(s)) for e, s, _ in mesh.boundary}
    for place in sorted(set(outer) ^ named):
        what = "belongs to one element and is no boundary edge" if place in outer else "is a boundary edge between two"
        faults.append(f"side {place[1]} of element {place[0]} {what}, {results.at(mesh.nodes[mesh.side(*place)[0]])}")
    results.say("conformity of sides", not faults, f"{len(mesh.elems)} quads, {len(outer)} sides of one element", faults)
    return neighbour


def check_doubles(face, mesh, results, tolerance):
    """No two nodes in one place, except on open interfaces."""
    is_open = {c for _, _, c in mesh.boundary if face.partners[c] >= 0}
    on_open = {int(n) for e, s, c in mesh.boundary if c in is_open for n in mesh.side(e, s)}
    used = np.unique(mesh.elems)
    cell = np.round(mesh.nodes[used] / max(4 * tolerance, 1e-300)).astype(np.int64)
    cells, faults = {}, []
    for node, (i, j) in zip(used, cell):
        near = [n for di in (-1, 0, 1) for dj in (-1, 0, 1) for n in cells.get((i + di, j + dj), ())]
        for other in near:
            if np.hypot(*(mesh.nodes[node] - mesh.nodes[other])) <= tolerance and not {int(node), int(other)} <= on_open:
                faults.append(f"nodes {other} and {node} lie in one place, {results.at(mesh.nodes[node])}")
        cells.setdefault((i, j), []).append(node)
    results.say("one node in one place", not faults, f"{len(used)} nodes, {len(on_open)} on open interfaces", faults)


def check_interface_edges(face, mesh, results):
    known, faults = {}, []
    for e, s, c in mesh.interface:
        known[tuple(mesh.side(e, s))] = int(c)
        if face.partners[c] < 0:
            faults.append(f"side {s} of element {e} is an interface edge on curve {c}, which is on the boundary")
        if mesh.region[e] != face.region_of[c]:
            faults.append(f"side {s} of element {e} of region {mesh.region[e]} is on curve {c} of region "
                          f"{face.region_of[c]}, {results.at(mesh.nodes[mesh.side(e, s)[0]])}")
    for nodes, c in known.items():
        if known.get(nodes[::-1]) != face.partners[c]:
            faults.append(f"an edge on curve {c} is not there from the other side with the same nodes, "
                          f"{results.at(mesh.nodes[nodes[0]])}")
    results.say("both sides of interfaces", not faults, f"{len(mesh.interface)} edges", faults)


def check_loops(face, mesh, results):
    """Edges on the boundary and on interfaces together run along each loop of the face, without gap."""
    edges = np.concatenate([mesh.boundary, mesh.interface])
    edges = edges[np.argsort(edges[:, 2], kind="stable")]
    faults = []
    for loop in range(len(face.loops) - 1):
        own = edges[face.loop_of[edges[:, 2]] == loop]
        if len(own) == 0:
            faults.append(f"no edge lies on loop {loop}")
        for k in range(len(own)):
            end, start = mesh.side(own[k][0], own[k][1])[-1], mesh.side(*own[(k + 1) % len(own)][:2])[0]
            if end != start:
                faults.append(f"an edge on curve {own[k][2]} ends {results.at(mesh.nodes[end])}, where none begins")
    results.say("edges along loops", not faults, f"{len(face.loops) - 1} loops, {len(edges)} edges", faults)


def check_on_curves(face, mesh, edges, what, results, tolerance):
    """Edges that pass a smooth joint may also lie on the neighbouring curves."""
    worst, faults = 0.0, []
    for c in np.unique(edges[:, 2]):
        own = edges[edges[:, 2] == c]
        nodes = np.unique(np.concatenate([mesh.side(e, s) for e, s, _ in own]))
        points = mesh.nodes[nodes]
        distance = face.curves[c].distances(points) / face.diameter
        for other in (face.previous(c), face.next(c)):
            far = distance > tolerance
            if far.any():
                distance[far] = np.minimum(distance[far], face.curves[other].distances(points[far]) / face.diameter)
        worst = max(worst, distance.max())
        faults += [f"node {n} is {d:.2e} diameters from curve {c} ({face.names[c]}), {results.at(mesh.nodes[n])}"
                   for n, d in zip(nodes, distance) if d > tolerance]
    results.say(f"{what} nodes on CAD curves", not faults, f"at most {worst:.2e} diameters (at most {tolerance:.0e}), "
                f"{len(edges)} edges", faults)


def parts_between_interfaces(mesh, neighbour):
    """A number for each element: the same for those that are connected without an interface between them."""
    is_cut = np.zeros((len(mesh.elems), 4), bool)
    for e, s, _ in mesh.interface:
        is_cut[e, s] = True
    part = np.full(len(mesh.elems), -1)
    for first in range(len(mesh.elems)):
        if part[first] >= 0:
            continue
        part[first], todo = first, [first]
        while todo:
            elem = todo.pop()
            for side in range(4):
                other = neighbour[elem, side]
                if other >= 0 and not is_cut[elem, side] and part[other] < 0:
                    part[other] = first
                    todo.append(other)
    return part


def check_regions(face, mesh, neighbour, results, samples):
    part, faults = parts_between_interfaces(mesh, neighbour), []
    middle = mesh.elems[:, [0, 0, -1, -1], [0, -1, 0, -1]]
    centres = mesh.nodes[mesh.elems[:, mesh.order // 2, mesh.order // 2]] if mesh.order > 1 else \
        mesh.nodes[middle].mean(axis=1)
    for number in np.unique(part):
        elems = np.flatnonzero(part == number)
        if len(set(mesh.region[elems])) > 1:
            faults.append(f"elements of regions {sorted(set(map(int, mesh.region[elems])))} are connected without an "
                          f"interface between them, {results.at(centres[elems[0]])}")
        for elem in elems[::max(1, len(elems) // samples)]:
            inside = [r for r in range(face.num_regions) if face.winding(r, centres[elem]) != 0]
            if inside != [mesh.region[elem]]:
                faults.append(f"element {elem} is of region {mesh.region[elem]}, but lies in {inside}, "
                              f"{results.at(centres[elem])}")
    for block in np.unique(mesh.block):
        if len(set(part[mesh.block == block])) > 1:
            faults.append(f"block {block} has elements on both sides of an interface")
    results.say("regions", not faults, f"{face.num_regions} regions, {len(np.unique(part))} parts between interfaces, "
                f"{len(np.unique(mesh.block))} blocks", faults)


def check_cracks(face, mesh, results, tolerance):
    """Open interfaces: boundary edges on both sides."""
    chains = {}
    for e, s, c in mesh.boundary:
        if face.partners[c] >= 0:
            chain = chains.setdefault(int(c), [])
            nodes = list(mesh.side(e, s))
            chain += nodes if not chain else nodes[1:]
    if not chains:
        return
    closed_ends = {int(n) for e, s, _ in mesh.interface for n in mesh.side(e, s)[[0, -1]]}
    worst, num_doubled, faults = 0.0, 0, []
    for c, one in chains.items():
        other = chains.get(int(face.partners[c]), [])[::-1]
        if face.region_of[c] != face.region_of[face.partners[c]]:
            if c < face.partners[c]:
                results.say(f"open interface {face.names[c]}", bool(other), f"{len(one)} and {len(other)} nodes")
            continue
        if len(one) != len(other):
            faults.append(f"curve {c} has {len(one)} nodes, its other side {len(other)}")
            continue
        gaps = np.hypot(*(mesh.nodes[one] - mesh.nodes[other]).T) / face.diameter
        worst = max(worst, gaps.max())
        faults += [f"nodes {a} and {b} of both sides of curve {c} are {g:.2e} diameters apart, "
                   f"{results.at(mesh.nodes[a])}" for a, b, g in zip(one, other, gaps) if g > tolerance]
        faults += [f"node {a} inside the open curve {c} is not doubled, {results.at(mesh.nodes[a])}"
                   for a, b in list(zip(one, other))[1:-1] if a == b]
        num_doubled += sum(a != b for a, b in zip(one, other))
        tips = face.previous(c) == face.partners[c], face.next(c) == face.partners[c]
        for end, is_tip in zip((0, -1), tips):
            a, b = one[end], other[end]
            if is_tip and a != b:
                faults.append(f"the tip of the open curve {c} is doubled, {results.at(mesh.nodes[a])}")
            if not is_tip and a == b and int(a) not in closed_ends:
                faults.append(f"the end of the open curve {c} is not doubled, {results.at(mesh.nodes[a])}")
    if all(face.region_of[c] != face.region_of[face.partners[c]] for c in chains):
        return
    results.say("cracks", not faults, f"{len(chains)} sides, {num_doubled // 2} doubled nodes, at most {worst:.2e} "
                f"diameters apart (at most {tolerance:.0e})", faults)


def check_periodic(face, mesh, results, tolerance):
    """Curves of the same motion together: an edge may pass a joint between them."""
    if not face.pairs:
        return
    motions = {}
    for curves, angle, shift in face.pairs:
        key = (round(float(angle), 12), *(round(float(s) / face.diameter, 12) for s in shift))
        entry = motions.setdefault(key, (float(angle), np.asarray(shift, float), set(), set()))
        entry[2].add(int(curves[0]))
        entry[3].add(int(curves[1]))
    worst, num_pairs, faults = 0.0, 0, []
    for angle, shift, first, second in motions.values():
        nodes = [np.unique(np.concatenate([mesh.side(e, s) for e, s, c in mesh.boundary if c in curves] or
                                          [np.zeros(0, int)])) for curves in (first, second)]
        if len(nodes[0]) != len(nodes[1]) or len(nodes[0]) == 0:
            faults.append(f"curves {sorted(first)} have {len(nodes[0])} nodes, curves {sorted(second)} "
                          f"{len(nodes[1])}")
            continue
        turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        moved = (mesh.nodes[nodes[0]] + face.origin) @ turn.T + shift - face.origin
        apart = np.hypot(*np.moveaxis(moved[:, None] - mesh.nodes[nodes[1]][None], 2, 0)) / face.diameter
        nearest = apart.min(axis=1)
        worst, num_pairs = max(worst, nearest.max()), num_pairs + len(nearest)
        faults += [f"node {n} of curves {sorted(first)} is mapped {d:.2e} diameters from the next node of curves "
                   f"{sorted(second)}, {results.at(mesh.nodes[n])}" for n, d in zip(nodes[0], nearest) if d > tolerance]
        if len(set(apart.argmin(axis=1))) != len(nearest):
            faults.append(f"two nodes of curves {sorted(first)} are mapped onto one of curves {sorted(second)}")
    results.say("periodic nodes", not faults, f"{num_pairs} pairs, at most {worst:.2e} diameters apart "
                f"(at most {tolerance:.0e})", faults)


def check_same_face(face, other, results):
    """The curves of --face are those of the mesh."""
    faults = []
    if len(face.curves) != len(other.curves) or list(face.partners) != list(other.partners):
        faults.append(f"{len(face.curves)} and {len(other.curves)} curves, or other partners")
    else:
        for c, (a, b) in enumerate(zip(face.curves, other.curves)):
            if a.homogeneous.shape != b.homogeneous.shape or not np.array_equal(a.homogeneous, b.homogeneous):
                faults.append(f"curve {c} ({face.names[c]})")
    results.say("curves of both files", not faults, f"{len(face.curves)}", faults)
    return not faults


def check(path, options):
    with h5py.File(path, "r") as file:
        face, mesh = Face(file), Mesh(file)
    results = Results(face)
    if options.face:
        with h5py.File(options.face, "r") as file:
            other = Face(file)
        if not check_same_face(face, other, results):
            return results.num_faults
        face = other
    length = options.distance_tolerance
    neighbour = check_sides(mesh, results)
    check_doubles(face, mesh, results, options.pair_tolerance * face.diameter)
    check_loops(face, mesh, results)
    check_interface_edges(face, mesh, results)
    check_regions(face, mesh, neighbour, results, options.samples)
    check_areas(face, mesh, results, options.area_tolerance)
    check_on_curves(face, mesh, mesh.boundary, "boundary", results, length)
    if len(mesh.interface):
        check_on_curves(face, mesh, mesh.interface, "interface", results, length)
    check_cracks(face, mesh, results, options.pair_tolerance)
    check_periodic(face, mesh, results, options.pair_tolerance)
    return results.num_faults


def main():
    parser = argparse.ArgumentParser(description="checks a quad mesh of several regions")
    parser.add_argument("mesh", help="x.quad.h5")
    parser.add_argument("--face", help="stage file with the face, such as x.tri.h5; else that of the mesh")
    parser.add_argument("--area-tolerance", type=float, default=1e-10, help="relative; default: 1e-10")
    parser.add_argument("--distance-tolerance", type=float, default=1e-10, help="of nodes from curves, in diameters")
    parser.add_argument("--pair-tolerance", type=float, default=1e-12, help="of doubled and periodic nodes, in diameters")
    parser.add_argument("--samples", type=int, default=20, help="elements located in each part of the mesh")
    options = parser.parse_args()
    try:
        num_faults = check(options.mesh, options)
    except (OSError, KeyError) as error:
        print(f"check_regions.py: {error}", file=sys.stderr)
        return 3
    return 1 if num_faults else 0


if __name__ == "__main__":
    sys.exit(main())
