"""Meshes of small quads, as readers without high order have them: what makes one, and the elements that they were."""
from element_mesh import ElementMesh, side_indices


def require_mesh(points, quads, edges):
    """Points are used, quads convex and counter-clockwise, each pair of corners joined by at most two of them, once in
    each direction; `edges` (a, b) -> name are those of one quad alone."""
    assert {p for quad in quads for p in quad} == set(range(len(points))), "points without a quad"
    joined = {}
    for number, quad in enumerate(quads):
        for k in range(4):
            (ax, ay), (bx, by), (cx, cy) = (points[quad[(k + s) % 4]][:2] for s in (3, 0, 1))
            assert (cx - bx) * (ay - by) - (cy - by) * (ax - bx) > 0, f"quad {number} is not convex"
            side = quad[k], quad[(k + 1) % 4]
            assert side not in joined, f"two quads on the same side of {side}"
            joined[side] = number
    outside = {side for side in joined if side[::-1] not in joined}
    assert set(edges) == outside, "the boundary is not that of the quads"


def gathered(points, quads, edges, order, regions=None):
    """The elements whose N^2 pieces follow each other, the first coordinate fastest."""
    n, width = order, order + 1
    require_mesh(points, quads, edges)
    elements, boundaries, corners, names = [], {}, set(), []
    for e in range(len(quads) // n ** 2):
        grid = [None] * width ** 2
        for j in range(n):
            for i in range(n):
                quad = quads[(e * n + j) * n + i]
                for p, k in zip(quad, (j * width + i, j * width + i + 1, (j + 1) * width + i + 1, (j + 1) * width + i)):
                    assert grid[k] in (None, p), f"the pieces of element {e} do not fit"
                    grid[k] = p
        elements.append([points[p] for p in grid])
        corners |= {grid[k] for k in (0, n, n * width, n * width + n)}
        for side in range(4):
            line = [grid[k] for k in side_indices(n, side)]
            found = {edges.get(pair) for pair in zip(line, line[1:])}
            assert len(found) == 1, f"side {side} of element {e} has several names"
            if found != {None}:
                boundaries[e, side] = found.pop()
        if regions:
            own = set(regions[e * n * n:(e + 1) * n * n])
            assert len(own) == 1
            names.append(own.pop())
    return ElementMesh(n, elements, names if regions else None, boundaries, len(corners))
