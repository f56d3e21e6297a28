"""HOHQMesh's flavour of Abaqus .inp as Trixi.jl's P4estMesh reads it: p4est takes the straight quads, Trixi.jl itself
what the comments say."""
from pathlib import Path

from hohqmesh_element import element_mesh


def read(path, _order=None):
    text = Path(path).read_text(encoding="ascii")
    assert text.startswith("*Heading\n File created by HOHQMesh\n"), "Trixi.jl compares the second line"
    lines = text.splitlines()
    vertices, elements = straight_quads(lines)
    start = next(k for k, line in enumerate(lines) if "** mesh polynomial degree" in line)
    assert lines[start - 1] == "** ***** HOHQMesh boundary information ***** **"
    n = int(lines[start].split()[5])
    comments = iter([words_of(line) for line in lines[start + 1:]])
    corners, curved = [], []
    for _ in elements:
        corners.append([int(word) - 1 for word in next(comments)])
        flags = next(comments)
        assert len(flags) == 4 and set(flags) <= {"0", "1"}
        curved.append([[tuple(map(float, next(comments))) for _ in range(n + 1)] if flag == "1" else None
                       for flag in flags])
    names = []
    for _ in elements:
        left, right, low, high = next(comments)  # -x +x -y +y
        names.append([low, right, high, left])
    assert next(comments, None) is None, "something follows"
    return element_mesh(path, n, vertices, corners, curved, names, joined_sides(elements, corners))[0]


def joined_sides(elements, corners):
    """{(element, side): (other element, its side)} of sides that p4est takes for one though their corners differ:
    *ELEMENT has the same corners for both, the comments have their own."""
    def sides(quads):
        met = {}
        for e, ids in enumerate(quads):
            for side in range(4):
                met.setdefault(frozenset((ids[side], ids[(side + 1) % 4])), []).append((e, side))
        return met
    trees, drawn = sides(elements), sides(corners)
    assert all(len(places) <= 2 and len(ends) == 2 for ends, places in trees.items()), "p4est could not tell sides apart"
    alone = {places[0] for places in drawn.values() if len(places) == 1}
    pairs = [places for places in trees.values() if len(places) == 2 and alone.issuperset(places)]
    assert len(trees) == len(drawn) - len(pairs), "corners are joined that no periodic side has"
    return {a: b for pair in pairs for a, b in (pair, pair[::-1])}


def words_of(line):
    first, *rest = line.split()
    assert first == "**"
    return rest


def straight_quads(lines):
    """As p4est does: every *NODE and *ELEMENT section counts, up to the next line that begins with a star."""
    vertices, elements, section = [], [], None
    for line in lines:
        if line.startswith("*"):
            upper = line.upper()
            section = vertices if "*NODE" in upper else elements if "*ELEMENT" in upper and "TYPE=CPS4" in upper else None
        elif section is vertices:
            number, *x = line.split(", ")
            assert int(number) == len(vertices) + 1
            vertices.append(tuple(map(float, x)))
        elif section is elements:
            number, *corners = map(int, line.split(", "))
            assert number == len(elements) + 1 and len(corners) == 4
            elements.append([c - 1 for c in corners])
    return vertices, elements
