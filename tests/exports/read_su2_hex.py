"""SU2 meshes of hexahedra as SU2 reads them: key words with "=", cells by VTK's numbers, markers."""
import numpy

from element_mesh import real_names
from hex_mesh import CORNERS, FACES, HexElements
from read_su2 import key_words


def read(path):
    value, rows, is_at_end = key_words(path)
    assert value("NDIME") == "3"
    hexes, face_of = [], {}
    for number, row in enumerate(rows(int(value("NELEM")))):
        cell, *corners, index = map(int, row)
        assert (cell, index, len(corners)) == (12, number, 8)
        for face, local in enumerate(FACES):
            face_of.setdefault(frozenset(corners[c] for c in local), []).append((number, face))
        hexes.append(corners)
    points = []
    for number, row in enumerate(rows(int(value("NPOIN")))):
        assert int(row[3]) == number
        points.append([float(x) for x in row[:3]])
    assert {node for corners in hexes for node in corners} == set(range(len(points))), "a point without a cell"
    names, faces = real_names(path), []
    for _ in range(int(value("NMARK"))):
        tag = value("MARKER_TAG")
        for cell, *corners in rows(int(value("MARKER_ELEMS"))):
            corners = list(map(int, corners))
            (elem, face), = face_of.pop(frozenset(corners))  # of one cell, and in one marker
            seen = [hexes[elem][c] for c in FACES[face]]
            turn = seen.index(corners[0])
            assert cell == "9" and corners == seen[turn:] + seen[:turn], "not seen from outside"
            faces.append((elem, face, names.get(tag, tag)))
    assert all(len(cells) == 2 for cells in face_of.values()), "a face of the boundary has no marker"
    assert is_at_end(), "something follows"
    nodes = numpy.zeros((len(hexes), 2, 2, 2, 3))
    for c, (i, j, k) in enumerate(CORNERS):
        nodes[:, k, j, i] = numpy.array(points)[[corners[c] for corners in hexes]]
    return HexElements(1, nodes, None, faces)
