"""MFEM meshes of hexahedra, v1.0 and v1.3: nodes as an H1 grid function in MFEM's numbering of degrees of freedom, or
as an L2 one where periodic sides share vertices. Source of the numbering: MFEM, mesh.cpp, geom.cpp, fe_base.cpp."""
import re
from pathlib import Path

import numpy

from hex_mesh import CORNERS, EDGES, FACES, HexElements
from read_mfem import Words, name_sets, names_beside


def grid_of(order, corners, vertices, edges, faces, inside):
    """[k, j, i, axis] from the values at vertices, along edges, on faces (as their first element sees them)."""
    n = order
    nodes = numpy.full((n + 1, n + 1, n + 1, 3), numpy.nan)

    def at(c):
        return numpy.array([n * index for index in reversed(CORNERS[c])])

    for c, v in enumerate(corners):
        nodes[tuple(at(c))] = vertices[v]
    for a, b in EDGES:
        ends = (corners[a], corners[b])
        values = edges[frozenset(ends)][::1 if ends[0] < ends[1] else -1]
        for k in range(1, n):
            nodes[tuple(at(a) + k * (at(b) - at(a)) // n)] = values[k - 1]
    for face in FACES:
        mine = [corners[c] for c in face]
        base, values = faces[frozenset(mine)]
        start, u, v = (mine.index(base[k]) for k in (0, 1, 3))  # where the corners of the first element are here
        along, across = ((at(face[k]) - at(face[start])) // n for k in (u, v))
        for b in range(1, n):
            for a in range(1, n):
                nodes[tuple(at(face[start]) + a * along + b * across)] = values[(b - 1) * (n - 1) + a - 1]
    nodes[1:n, 1:n, 1:n] = numpy.reshape(inside, (n - 1, n - 1, n - 1, 3))
    return nodes


def h1_nodes(order, elements, num_vertices, words):
    inner = order - 1

    def take(count):
        return [words.floats(3) for _ in range(count)]

    vertices = take(num_vertices)
    edges, faces = {}, {}
    for corners in elements:
        for a, b in EDGES:
            edges.setdefault(frozenset((corners[a], corners[b])), None)
    for key in edges:
        edges[key] = take(inner)
    for corners in elements:
        for face in FACES:
            mine = [corners[c] for c in face]
            faces.setdefault(frozenset(mine), (mine, None))
    for key, (base, _) in faces.items():
        faces[key] = (base, take(inner ** 2))
    return numpy.array([grid_of(order, corners, vertices, edges, faces, take(inner ** 3)) for corners in elements])


def corner_nodes(elements, vertices):
    return numpy.array([[[[vertices[corners[CORNERS.index((i, j, k))]] for i in (0, 1)] for j in (0, 1)]
                         for k in (0, 1)] for corners in elements])


def read(path):
    words = Words(Path(path).read_text(encoding="utf-8"))
    has_names = words.title == "MFEM mesh v1.3"
    words.expect("dimension", "3", "elements")
    elements, attributes = [], []
    for _ in range(words.int()):
        attribute, shape, *corners = words.ints(10)
        assert shape == 5 and attribute >= 1
        elements.append(corners)
        attributes.append(attribute)
    region_names = name_sets(words, "attribute_sets") if has_names else None
    words.expect("boundary")
    boundary = [words.ints(6) for _ in range(words.int())]
    boundary_names = name_sets(words, "bdr_attribute_sets") if has_names else None
    words.expect("vertices")
    num_vertices = words.int()
    assert {v for corners in elements for v in corners} == set(range(num_vertices))
    order, word = 1, words.next()
    if word != "nodes":
        assert word == "3"
        nodes = corner_nodes(elements, [words.floats(3) for _ in range(num_vertices)])
    else:
        words.expect("FiniteElementSpace", "FiniteElementCollection:")
        space, order = re.fullmatch(r"(H1|L2_T1)_3D_P(\d+)", words.next()).groups()
        order = int(order)
        words.expect("VDim:", "3", "Ordering:", "1")
        if space == "H1":
            nodes = h1_nodes(order, elements, num_vertices, words)
        else:
            count = len(elements) * (order + 1) ** 3
            nodes = numpy.reshape(words.floats(3 * count), (len(elements),) + (order + 1,) * 3 + (3,))
    if has_names:
        words.expect("mfem_mesh_end")
    else:
        region_names, boundary_names = names_beside(path)
    assert words.at == len(words.words), "something follows"
    sides = {}
    for e, corners in enumerate(elements):
        for f, face in enumerate(FACES):
            sides.setdefault(tuple(corners[c] for c in face), (e, f))
    faces = []
    for attribute, shape, *corners in boundary:
        assert shape == 3
        turned = next(t for k in range(4) if (t := tuple(corners[k:] + corners[:k])) in sides)
        faces.append((*sides[turned], boundary_names[attribute]))
    return HexElements(order, nodes, [region_names[a] for a in attributes], faces)
