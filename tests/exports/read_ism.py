"""HOHQMesh ISM-V2 as Trixi.jl's UnstructuredMesh2D reads it: line by line, words parted by blanks."""
from pathlib import Path

from hohqmesh_element import element_mesh


def read(path, _order=None):
    lines = iter(Path(path).read_text(encoding="ascii").splitlines())
    assert next(lines).split() == ["ISM-V2"]
    num_nodes, num_edges, num_elements, n = map(int, next(lines).split())
    vertices = [point(next(lines)) for _ in range(num_nodes)]
    edges = [tuple(map(int, next(lines).split())) for _ in range(num_edges)]
    elements, curved, names = [], [], []
    for _ in range(num_elements):
        elements.append([int(word) - 1 for word in next(lines).split()])
        flags = next(lines).split()
        assert len(flags) == 4 and set(flags) <= {"0", "1"}
        curved.append([[point(next(lines)) for _ in range(n + 1)] if flag == "1" else None for flag in flags])
        names.append(next(lines).split())
    assert next(lines, None) is None, "something follows"
    joined = joined_sides(edges, elements)
    mesh, neighbours = element_mesh(path, n, vertices, elements, curved, names, joined)
    check_edges(edges, elements, neighbours, joined)
    return mesh


def point(line):
    x, y, z = map(float, line.split())
    return x, y, z


def joined_sides(edges, elements):
    """{(element, side): (other element, its side)} of edges between sides with other corners: periodic ones."""
    joined = {}
    for _, _, left, right, side, other in edges:
        one, two = (left - 1, side - 1), (right - 1, abs(other) - 1)
        ends = [{elements[e][s], elements[e][(s + 1) % 4]} for e, s in (one, two)] if right > 0 else []
        if ends and ends[0] != ends[1]:
            joined |= {one: two, two: one}
    return joined


def check_edges(edges, elements, neighbours, joined):
    """Each edge once: the left element lies on its left; the last number is negative where the points of the two sides
    come in opposite sequence. Round their elements both sides run in opposite directions."""
    assert len(edges) == 4 * len(elements) - (len(neighbours) + len(joined)) // 2, "an edge is missing or there twice"
    told = set()
    for a, b, left, right, side, other in edges:
        ids = elements[left - 1]
        assert (a - 1, b - 1) == (ids[side - 1], ids[side % 4]), "the element is not on the left"
        told.add((left - 1, side - 1))
        if right == 0:
            assert other == 0 and (left - 1, side - 1) not in neighbours
            continue
        if (left - 1, side - 1) in joined:
            assert (other > 0) == ((side > 2) != (abs(other) > 2)), "the points of a periodic side are reversed"
        else:
            assert neighbours[left - 1, side - 1] == (right - 1, abs(other) - 1, other > 0)
        told.add((right - 1, abs(other) - 1))
    assert len(told) == 4 * len(elements)
