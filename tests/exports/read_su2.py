"""SU2 meshes as SU2 reads them: key words with "=", cells by VTK's numbers, markers."""
import re
from pathlib import Path

from element_mesh import real_names
from linear_mesh import gathered


def key_words(path):
    """The functions value(key), of the next line, rows(count), the words of the next lines, and is_at_end()."""
    lines = [line for line in Path(path).read_text(encoding="ascii").split("\n") if line and not line.startswith("%")]
    at = 0

    def value(key):
        nonlocal at
        found = re.fullmatch(rf"{key}=\s*(\S+)", lines[at])
        assert found, f"no {key} in {lines[at]!r}"
        at += 1
        return found[1]

    def rows(count):
        nonlocal at
        at += count
        return [line.split() for line in lines[at - count:at]]

    return value, rows, lambda: at == len(lines)


def read(path, order):
    value, rows, is_at_end = key_words(path)
    assert value("NDIME") == "2"
    quads, points, edges = [], [], {}
    for number, row in enumerate(rows(int(value("NELEM")))):
        cell, *corners, index = map(int, row)
        assert (cell, index, len(corners)) == (9, number, 4)
        quads.append(corners)
    for number, (x, y, index) in enumerate(rows(int(value("NPOIN")))):
        assert int(index) == number
        points.append((float(x), float(y), 0.0))
    names = real_names(path)
    for _ in range(int(value("NMARK"))):
        tag = value("MARKER_TAG")
        for cell, a, b in rows(int(value("MARKER_ELEMS"))):
            assert cell == "3" and (int(a), int(b)) not in edges
            edges[int(a), int(b)] = names.get(tag, tag)
    assert is_at_end(), "something follows"
    return gathered(points, quads, edges, order)
