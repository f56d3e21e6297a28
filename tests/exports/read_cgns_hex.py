"""CGNS files of hexahedra by h5py alone: one zone, nodes of elements in the order of the standard (SIDS, tables of
HEXA_8, HEXA_27, HEXA_64 and HEXA_125, which number corners from 1)."""
import h5py
import numpy

from element_mesh import gll_points, real_names
from hex_mesh import CORNERS, FACES, HexElements, lagrange

SIDS_EDGES = ["12", "23", "34", "41", "15", "26", "37", "48", "56", "67", "78", "85"]
SIDS_FACES = ["1234", "1265", "2376", "3487", "4158", "5678"]  # from where their inner nodes are counted


def spiral(n):
    """Places (a, b) from 1 to n - 1 in rings, each counter-clockwise from its first corner."""
    places = []
    for low in range(1, n // 2 + 1):
        high = n - low
        places += [(a, low) for a in range(low, high)] + [(high, b) for b in range(low, high)]
        places += [(a, high) for a in range(high, low, -1)] + [(low, b) for b in range(high, low, -1)]
        places += [(low, low)] if low == high else []
    return places


def quad_places(n):
    steps = range(1, n)
    return ([(0, 0), (n, 0), (n, n), (0, n)] + [(k, 0) for k in steps] + [(n, k) for k in steps]
            + [(n - k, n) for k in steps] + [(0, n - k) for k in steps] + spiral(n))


def hex_places(n):
    corner = {str(c + 1): numpy.array(place) for c, place in enumerate(CORNERS)}
    places = [n * place for place in corner.values()]
    places += [(n - k) * corner[a] + k * corner[b] for a, b in SIDS_EDGES for k in range(1, n)]
    for p, q, _, s in SIDS_FACES:
        places += [n * corner[p] + a * (corner[q] - corner[p]) + b * (corner[s] - corner[p]) for a, b in spiral(n)]
    return places + [(a, b, c) for c in range(1, n) for a, b in spiral(n)]


def sections(zone):
    """(name, numbers of the elements, nodes of each from 0) in their order."""
    found = []
    for name, group in zone.items():
        if group.attrs.get("label", b"") == b"Elements_t":
            first, last = group["ElementRange/ data"][()]
            found.append((name, range(first, last + 1),
                          group["ElementConnectivity/ data"][()].reshape(last - first + 1, -1) - 1))
    return sorted(found, key=lambda section: section[1].start)


def read(path):
    with h5py.File(path) as file:
        assert list(file["base/ data"][()]) == [3, 3]
        zone = file["base/zone"]
        x = numpy.stack([zone[f"GridCoordinates/Coordinate{axis}/ data"][()] for axis in "XYZ"], axis=1)
        all_sections = sections(zone)
        boundaries = {name: list(group["PointRange/ data"][()].ravel()) for name, group in zone["ZoneBC"].items()}
        for group in zone["ZoneBC"].values():
            assert bytes(group["GridLocation/ data"][()].astype(numpy.uint8)) == b"FaceCenter"
    names, nodes, regions, faces, at_face, order, next_ = real_names(path), [], [], [], {}, None, 1
    for name, numbers, conn in all_sections:
        assert numbers.start == next_
        next_ = numbers.stop
        assert boundaries.get(name, [numbers.start, numbers.stop - 1]) == [numbers.start, numbers.stop - 1]
        n = round(conn.shape[1] ** (1 / 3)) - 1
        if (n + 1) ** 3 == conn.shape[1]:
            order = n
            ids = numpy.zeros((len(conn),) + (n + 1,) * 3, int)
            for column, (i, j, k) in enumerate(hex_places(n)):
                ids[:, k, j, i] = conn[:, column]
            for own in ids:
                cube = HexElements(n, own[None, ..., None], None, [])
                for face, local in enumerate(FACES):
                    seen = cube.face_nodes(0, face)[..., 0]
                    at_face.setdefault(frozenset(seen.ravel()), []).append((len(nodes), face, seen))
                nodes.append(x[own])
                regions.append(names.get(name, name))
            continue
        for row in conn:
            grid = numpy.zeros((order + 1, order + 1), int)
            for node, (a, b) in zip(row, quad_places(order)):
                grid[b, a] = node
            found = at_face[frozenset(row)]
            elem, face, seen = found[0]
            turns = [numpy.rot90(grid, k) for k in range(4)]
            assert any(numpy.array_equal(turn, seen) for turn in turns), "not the face, or not seen from outside"
            faces.append((elem, face, names.get(name, name)))
    values, _ = lagrange(numpy.linspace(-1, 1, order + 1), gll_points(order))
    nodes = numpy.einsum("ck,bj,ai,ekjix->ecbax", values, values, values, numpy.array(nodes), optimize=True)
    return HexElements(order, nodes, regions, faces)
