#!/usr/bin/python3
"""Which of its face's symmetries a layout has.

    symmetric_layout.py [--tolerance X] A.sep.json

Finds the isometries that map the face's outline onto itself (rotations about its centroid by 1/n of a turn, reflections
at lines through it), applies each to the layout's nodes and arcs, and compares within X diameters (default 1e-7). Prints
"kept K of N" and a line for each isometry that is not kept. Faces that any rotation maps onto themselves, discs and
annuli, have infinitely many: those with the layout's own angles are tried, and N is "all"."""
import argparse, cmath, math, sys

sys.dont_write_bytecode = True
import layout_graph

NODES, WEIGHTS = (  # Gauss-Legendre's rule of ten points
    (0.1488743389816312, 0.4333953941292472, 0.6794095682990244, 0.8650633666889845, 0.9739065285171717),
    (0.2955242247147529, 0.2692667193099964, 0.2190863625159820, 0.1494513491505806, 0.0666713443086881),
)
MOST = 12  # turns of the moments, which tell what rotations and axes there can be; no more than the quadrature resolves


def quadrature(path):
    """(point, tangent times weight) along a CAD curve; its pieces between knots are cut in four."""
    ((curve, _, _),) = path.pieces
    ends = [a + (b - a) * k / 4 for a, b in zip(curve.breaks, curve.breaks[1:]) for k in range(4)] + [curve.breaks[-1]]
    for low, high in zip(ends, ends[1:]):
        for node, weight in zip(NODES, WEIGHTS):
            for x in (node, -node):
                t, step = (low + high + x * (high - low)) / 2, 1e-4 * (high - low)
                yield curve(t), tangent(curve, t, step) * weight * (high - low) / 2


def tangent(curve, t, h):
    """A central difference of order four: the step is a ten-thousandth of a smooth piece."""
    return (8 * (curve(t + h) - curve(t - h)) - curve(t + 2 * h) + curve(t - 2 * h)) / (12 * h)


def centroid(points):
    """By Green: the integral of z over the area is that of conj(z) z / (2i) dz."""
    origin = points[0][0]
    area = sum(((z - origin).conjugate() * dz).imag for z, dz in points) / 2
    first = sum(abs(z - origin) ** 2 * dz for z, dz in points) / 2j
    return origin + first / area


def mirrors(moment, order):
    """Angles of the lines that may be axes: at them the moment of this order equals its own reflection."""
    return [(cmath.phase(moment) + math.pi * k) / order for k in range(order)]


def rotation(centre, angle):
    return lambda z: centre + cmath.exp(1j * angle) * (z - centre)


def reflection(centre, axis):
    return lambda z: centre + cmath.exp(2j * axis) * (z - centre).conjugate()


def candidates(moments, centre):
    """(name, image) of the rotations and reflections that the moments do not rule out."""
    orders = [m for m in moments if abs(moments[m]) > 1e-6]
    for n in range(2, MOST + 1):
        if not any(m % n for m in orders):
            yield from ((f"rotation by {k}/{n} of a turn", rotation(centre, 2 * math.pi * k / n))
                        for k in range(1, n) if math.gcd(k, n) == 1)
    for axis in mirrors(moments[orders[0]], orders[0]) if orders else []:
        yield f"reflection at {math.degrees(axis) % 180:.6g} degrees", reflection(centre, axis)


def is_round(graph, centre):
    """Whether any rotation maps the outline onto itself."""
    radii = [[abs(point - centre) for _, point in path.samples] for path in graph.outline]
    return all(max(each) - min(each) < 1e-9 * graph.diameter for each in radii)


def maps_outline(graph, image, tolerance):
    points = [image(path(share)) for path in graph.outline for share in (0.0, 0.137, 0.382, 0.618, 0.91)]
    candidates = lambda point: sorted(graph.outline, key=lambda path: path.rough_distance(point))[:3]
    return all(min(path.distance(point) for path in candidates(point)) < tolerance for point in points)


def kept(graph, image, tolerance):
    try:
        distance, where = layout_graph.apart(graph, graph, image)
    except layout_graph.Differs as difference:
        return str(difference)
    return "" if distance <= tolerance else f"off by {distance / graph.diameter:.2g} diameters, {where}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tolerance", type=float, default=1e-7)
    parser.add_argument("graph", type=layout_graph.Graph)
    options = parser.parse_args()
    graph, tolerance = options.graph, options.tolerance * options.graph.diameter
    points = [sample for path in graph.outline for sample in quadrature(path)]
    centre, size = centroid(points), graph.diameter / 2
    share = lambda z, m: ((z - centre) / size) ** m
    turns = range(1, MOST + 1)
    if is_round(graph, centre):
        moments = {m: sum(share(node.position, m) for node in graph.nodes) for m in turns}
        faults = [kept(graph, image, tolerance) for _, image in candidates(moments, centre)]
        print(f"kept {1 + faults.count('')} of all")
        return
    moments = {m: sum(share(z, m) * abs(dz) for z, dz in points) / size for m in turns}
    images = [pair for pair in candidates(moments, centre) if maps_outline(graph, pair[1], 1e-7 * graph.diameter)]
    faults = [(name, kept(graph, image, tolerance)) for name, image in images]
    print(f"kept {1 + sum(not fault for _, fault in faults)} of {1 + len(images)}")
    for name, fault in faults:
        if fault:
            print(f"  {name}: {fault}")


main()
