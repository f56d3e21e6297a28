"""Abaqus .inp as CalculiX reads it: key words in lines that begin with *, numbers of at most 20 characters, elements of 4
or 8 nodes, node sets, and surfaces as sides of elements."""
from pathlib import Path

from element_mesh import ElementMesh, real_names

# The 9 nodes of an element of order 2 in rows, by their place in the file; the middle is the blend of the sides.
ROWS = (0, 4, 1, 7, None, 5, 3, 6, 2)


def sections(path):
    """(key word, {parameter: value}, lines of words)"""
    found = []
    for line in Path(path).read_text(encoding="ascii").splitlines():
        words = [word.strip() for word in line.split(",")]
        if line.startswith("*"):
            parameters = dict(word.split("=") for word in words[1:])
            found.append((words[0], parameters, []))
        else:
            found[-1][2].append(words)
    return found


def middle(nodes):
    """Of a serendipity element: half of the middles of sides less a quarter of the corners."""
    return tuple(sum(n[c] for n in nodes[4:]) / 2 - sum(n[c] for n in nodes[:4]) / 4 for c in range(3))


def read(path, _order=None):
    points, elements, regions, sets, surfaces, kinds = {}, {}, {}, {}, {}, set()
    for key, parameters, rows in sections(path):
        if key == "*NODE":
            for number, *x in rows:
                assert len(x) == 3 and max(map(len, x)) <= 20, x
                points[int(number)] = tuple(map(float, x))
        elif key == "*ELEMENT":
            kinds.add(parameters["TYPE"])
            for number, *nodes in rows:
                elements[int(number)] = list(map(int, nodes))
                regions[int(number)] = parameters["ELSET"]
        elif key == "*NSET":
            sets[parameters["NSET"]] = {int(word) for row in rows for word in row if word}
            assert max(map(len, rows)) <= 17
        elif key == "*SURFACE":
            assert parameters["TYPE"] == "ELEMENT"
            surfaces[parameters["NAME"]] = [(int(number), int(side.removeprefix("S"))) for number, side in rows]
        elif key == "*ELSET":
            assert parameters == {"ELSET": "EALL"} and {row[0] for row in rows} == set(regions.values())
    (kind,) = kinds
    assert kind[:3] in ("CPS", "CPE", "CAX") and kind[3:] in "48"
    order = 1 if kind[3:] == "4" else 2
    assert sorted(elements) == list(range(1, len(elements) + 1))
    assert {n for nodes in elements.values() for n in nodes} == set(points) == set(range(1, len(points) + 1))
    return mesh_of(path, order, points, elements, regions, sets, surfaces)


def mesh_of(path, order, points, elements, regions, sets, surfaces):
    names, of_regions = real_names(path), real_names(path, "regions")
    boundaries = {}
    for word, sides in surfaces.items():
        on_sides = set()
        for number, side in sides:
            nodes = elements[number]
            on_sides |= {nodes[side - 1], nodes[side % 4]} | ({nodes[3 + side]} if order == 2 else set())
            assert (number - 1, side - 1) not in boundaries
            boundaries[number - 1, side - 1] = names.get(word, word)
        assert on_sides == sets[word], f"{word} has other nodes as a set than as a surface"
    made = []
    for number in sorted(elements):
        nodes = [points[n] for n in elements[number]]
        rows = (0, 1, 3, 2) if order == 1 else ROWS
        made.append([middle(nodes) if k is None else nodes[k] for k in rows])
    corners = {n for nodes in elements.values() for n in nodes[:4]}
    words = [regions[number] for number in sorted(elements)]
    return ElementMesh(order, made, [of_regions.get(word, word) for word in words], boundaries, len(corners))
