"""What HOHQMesh's two formats have in common: elements by their sides, at Chebyshev-Lobatto points in the direction of
the local coordinate, and the reader's blend of the sides (Kopriva 2009, algorithm 98)."""
from math import cos, pi

from element_mesh import ElementMesh, gll_points, real_names

# Side k joins these two corners, in the direction in which its points are listed.
SIDE_CORNERS = ((0, 1), (1, 2), (3, 2), (0, 3))


def chebyshev_lobatto(n):
    return [-cos(j * pi / n) for j in range(n + 1)]


def lagrange(points, values, t):
    """The polynomial through (points, values) at t."""
    for p, v in zip(points, values):
        if p == t:
            return v
    total = tuple(0.0 for _ in values[0])
    for k, v in enumerate(values):
        weight = 1.0
        for m, p in enumerate(points):
            if m != k:
                weight *= (t - p) / (points[k] - p)
        total = tuple(a + weight * b for a, b in zip(total, v))
    return total


def side_curve(corners, side, points, n):
    """t -> position: listed points of a curved side, or the segment."""
    if points is None:
        a, b = (corners[c] for c in SIDE_CORNERS[side])
        return lambda t: tuple((1 - t) / 2 * p + (1 + t) / 2 * q for p, q in zip(a, b))
    nodes = chebyshev_lobatto(n)
    return lambda t: lagrange(nodes, points, t)


def blended(corners, curved, n):
    """Positions at the (n+1)^2 GLL points; `curved`: four lists of points, None for a straight side."""
    curve = [side_curve(corners, side, curved[side], n) for side in range(4)]
    gll = gll_points(n)
    low, high, left, right = ([curve[k](t) for t in gll] for k in (0, 2, 3, 1))
    nodes = []
    for j, eta in enumerate(gll):
        for i, xi in enumerate(gll):
            nodes.append(tuple(
                ((1 - xi) * left[j][c] + (1 + xi) * right[j][c] + (1 - eta) * low[i][c] + (1 + eta) * high[i][c]) / 2
                - ((1 - xi) * ((1 - eta) * low[0][c] + (1 + eta) * high[0][c])
                   + (1 + xi) * ((1 - eta) * low[n][c] + (1 + eta) * high[n][c])) / 4 for c in range(3)))
    return nodes


def check_sides(elements, vertices, curved, n):
    """Sides end at their corners; a side inside is the same, number for number, from both its elements. Returns
    {(element, side): (other element, side, is the sequence of points the same)}."""
    seen, neighbours = {}, {}
    for e, ids in enumerate(elements):
        for side, ends in enumerate(SIDE_CORNERS):
            a, b = (ids[c] for c in ends)
            points = curved[e][side]
            if points is not None:
                assert len(points) == n + 1
                assert points[0] == vertices[a] and points[-1] == vertices[b], f"side {side} of {e} misses its corners"
            key = frozenset((a, b))
            if key not in seen:
                seen[key] = (e, side, a, points)
                continue
            f, other, start, theirs = seen[key]
            same_way = start == a
            if theirs is not None and not same_way:
                theirs = theirs[::-1]
            assert points == theirs, f"elements {f} and {e} differ on their common side"
            neighbours[f, other], neighbours[e, side] = (e, side, same_way), (f, other, same_way)
    return neighbours


def element_mesh(path, n, vertices, elements, curved, names, joined=()):
    """names: for each element four words, "---" inside; joined: {(element, side): (element, side)} across periodic
    sides, which count as inside."""
    neighbours = check_sides(elements, vertices, curved, n)
    assert not set(joined) & set(neighbours)
    said = real_names(path)
    boundaries = {}
    for e, words in enumerate(names):
        assert len(words) == 4
        for side, word in enumerate(words):
            assert (word == "---") == ((e, side) in neighbours or (e, side) in joined), f"side {side} of {e} is called {word}"
            if word != "---":
                boundaries[e, side] = said.get(word, word)
    assert {v for ids in elements for v in ids} == set(range(len(vertices)))
    nodes = [blended([vertices[v] for v in ids], curved[e], n) for e, ids in enumerate(elements)]
    mesh = ElementMesh(n, nodes, None, boundaries, len(vertices), numbers={"joined": dict(joined)})
    return mesh, neighbours
