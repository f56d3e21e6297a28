"""SPECFEM2D's text files: a count in the first line, then a line each."""
import json
from pathlib import Path

from element_mesh import ElementMesh

ROWS = {4: (0, 1, 3, 2), 9: (0, 4, 1, 7, 8, 5, 3, 6, 2)}


def table(path, kind, has_count=True):
    rows = [[kind(word) for word in line.split()] for line in Path(path).read_text(encoding="ascii").splitlines()]
    if has_count:
        assert rows[0] == [len(rows) - 1], path
    return rows[has_count:]


def read(path, _order=None):
    quads, points = table(path, int), table(f"{path}.nodes", float)
    assert {n for quad in quads for n in quad} == set(range(1, len(points) + 1))
    groups = json.loads(Path(f"{path}.names.json").read_text(encoding="utf-8"))
    regions = {group["id"]: group["name"] for group in groups["regions"]}
    elements = [[(*points[quad[k] - 1], 0.0) for k in ROWS[len(quad)]] for quad in quads]
    sides = {}
    for ending in ("free_surface", "absorbing_surface"):
        for elem, count, a, b, *way in table(f"{path}.{ending}", int):
            quad = quads[elem - 1]
            side = quad.index(a)
            assert count == 2 and quad[(side + 1) % 4] == b and side < 4 and (elem - 1, side) not in sides
            (xa, ya, *_), (xb, yb, *_) = points[a - 1], points[b - 1]
            normal = {1: xb - xa, 2: yb - ya, 3: xa - xb, 4: ya - yb}  # below, right, above, left
            assert not way or normal[way[0]] == max(normal.values())
            sides[elem - 1, side] = ending.split("_")[0]
    corners = {n for quad in quads for n in quad[:4]}
    return ElementMesh(round(len(elements[0]) ** 0.5) - 1, elements,
                       [regions[number] for (number,) in table(f"{path}.materials", int, False)], sides, len(corners))
