#!/usr/bin/env python3
"""Checks the periodic sides of exported files:

    check_periodic.py [--composites A=B ...] [--stage x.quad.h5] FILE ...

FILE is *.msh, *.re2, *.mesh, *.inp, *.ism or *.xml, of which the composites A and B are periodic. Prints the number of
pairs of nodes (*.msh) or sides of each file and how far they are apart, after the file's own motion or, where the file
has none, after the one that maps the ends of each side. With --stage, elements and names of meshes whose sides are
joined by their numbers (*.mesh, *.inp, *.ism) are compared to those of the stage file."""
import argparse
import struct

import read_inp
import read_ism
import read_mfem
import read_nektar
import stage_mesh
from element_mesh import differences, gll_points, side_indices


def section(text, name):
    return iter(text.split(f"${name}\n")[1].split(f"$End{name}")[0].splitlines())


def nodes_of(text, version):
    lines = section(text, "Nodes")
    if version == "2.2":
        return {int(tag): list(map(float, x)) for tag, *x in map(str.split, list(lines)[1:])}
    nodes = {}
    for _ in range(int(next(lines).split()[0])):
        count = int(next(lines).split()[3])
        tags = [int(next(lines)) for _ in range(count)]
        nodes |= {tag: list(map(float, next(lines).split())) for tag in tags}
    return nodes


def msh(path):
    with open(path, encoding="utf-8") as file:
        text = file.read()
    version = text.split()[1]
    nodes, lines = nodes_of(text, version), section(text, "Periodic")
    count, worst, entities = 0, 0.0, set()
    for _ in range(int(next(lines))):
        dim, entity, master = map(int, next(lines).split())
        assert entity != master and (dim, entity) not in entities
        entities.add((dim, entity))
        first, *numbers = next(lines).split()
        assert first == ("Affine" if version == "2.2" else "16")
        motion = list(map(float, numbers))
        for _ in range(int(next(lines))):
            node, of = map(int, next(lines).split())
            x = nodes[of] + [1.0]
            image = [sum(motion[4 * i + j] * x[j] for j in range(4)) for i in range(3)]
            worst = max(worst, *(abs(a - b) for a, b in zip(image, nodes[node])))
            count += 1
    return count, worst


def re2(path):
    """The partner of a partner is the side itself, and all pairs are of equal length."""
    with open(path, "rb") as file:
        data = file.read()
    count, at = int(data[5:21]), 84
    corners = []
    for _ in range(count):
        _, *x = struct.unpack_from("<9d", data, at)
        at += 72
        corners.append([(x[k], x[4 + k]) for k in range(4)])
    at += 8 + 64 * int(struct.unpack_from("<d", data, at)[0])
    number, at, partners = int(struct.unpack_from("<d", data, at)[0]), at + 8, {}
    for _ in range(number):
        elem, side, other, other_side = (int(x) for x in struct.unpack_from("<4d", data, at))
        if data[at + 56:at + 64] == b"P       ":
            partners[elem, side] = other, other_side
        at += 64
    def chord(elem, side):
        a, b = corners[elem - 1][side - 1], corners[elem - 1][side % 4]
        return ((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2) ** 0.5
    assert all(partners[b] == a for a, b in partners.items())
    return len(partners) // 2, max(abs(chord(*a) - chord(*b)) for a, b in partners.items())


def apart(sides):
    """Of pairs of sides, each two lists of nodes that run in one direction: how far the image of the one is from the
    other, by the motion that maps its first node and the direction to its last. There are at most two motions, up to
    inversion."""
    worst, motions = 0.0, set()
    for one, other in sides:
        a, b = [complex(*x[:2]) for x in one], [complex(*x[:2]) for x in other]
        turn = (b[-1] - b[0]) / (a[-1] - a[0])
        worst = max(worst, abs(abs(turn) - 1), *(abs(b[0] + turn * (x - a[0]) - y) for x, y in zip(a, b)))
        shift = b[0] - turn * a[0]
        motions.add(max(tuple(round(x, 7) + 0.0 for z in motion for x in (z.real, z.imag))
                        for motion in ((turn, shift), (1 / turn, -shift / turn))))
    assert len(motions) <= 2, f"{len(motions)} motions"
    return worst


def joined(mesh, pairs, names):
    """Each pair of sides once; `names`: whether joined sides keep the names that they have in the stage file."""
    n, sides = mesh.order, []
    for (e, side), (f, other) in pairs.items():
        if (e, side) < (f, other):
            sides.append(([mesh.elements[e][k] for k in side_indices(n, side)],
                          [mesh.elements[f][k] for k in side_indices(n, other)][::-1]))
    if options.stage:
        wanted = stage_mesh.read(options.stage)
        mesh.num_vertices = wanted.num_vertices
        if names:  # the stage file's reader knows no interfaces
            mesh.boundaries = {key: name for key, name in mesh.boundaries.items() if key in wanted.boundaries}
        else:
            assert set(pairs) <= set(wanted.boundaries)
            wanted.boundaries = {key: name for key, name in wanted.boundaries.items() if key not in pairs}
        found = differences(mesh, wanted)
        assert not found, found
    return len(sides), apart(sides)


def mfem(path):
    """Sides with the same vertices at different places."""
    mesh = read_mfem.read(path)
    n, met, pairs = mesh.order, {}, {}
    for e, corners in enumerate(mesh.numbers["corners"]):
        for side in range(4):
            a, b = corners[side], corners[(side + 1) % 4]
            assert a != b and (a, b) not in met, "MFEM could not distinguish two edges"
            met[a, b] = e, side
    for (a, b), (e, side) in met.items():
        if (b, a) not in met:
            continue
        f, other = met[b, a]
        nodes = [[mesh.elements[i][k] for k in side_indices(n, s)] for i, s in ((e, side), (f, other))]
        if max(abs(p - q) for x, y in zip(nodes[0], nodes[1][::-1]) for p, q in zip(x, y)) > 1e-9:
            pairs[e, side] = f, other
    return joined(mesh, pairs, names=True)


def hohqmesh(read):
    def check(path):
        mesh = read(path)
        return joined(mesh, mesh.numbers["joined"], names=False)
    return check


def nektar(path):
    """The k-th edges of both composites, the first as its element runs round, the second the other way."""
    geometry = read_nektar.Geometry(read_nektar.ElementTree.parse(path).getroot())
    number = {c.get("NAME"): read_nektar.unrolled(c.text, "E") for c in geometry.composites.values() if "E[" in c.text}
    place = {edge: (quad, j) for quad, edges in geometry.quads.items() for j, edge in enumerate(edges)}
    points = gll_points(geometry.order or 1)
    def side(edge):
        quad, j = place[edge]
        return geometry.side(quad, j, geometry.corners(quad)[j], points)
    sides = []
    for pair in options.composites:
        one, other = (number[name] for name in pair.split("="))
        assert len(one) == len(other) > 0
        sides += [(side(a), side(b)[::-1]) for a, b in zip(one, other)]
    return len(sides), apart(sides)


parser = argparse.ArgumentParser()
parser.add_argument("--composites", action="append", default=[])
parser.add_argument("--stage")
parser.add_argument("files", nargs="+")
options = parser.parse_args()
READERS = {"msh": msh, "re2": re2, "mesh": mfem, "inp": hohqmesh(read_inp.read), "ism": hohqmesh(read_ism.read),
           "xml": nektar}
for name in options.files:
    count, distance = READERS[name.rsplit(".", 1)[1]](name)
    print(f"{name}: {count} pairs, at most {distance:.1e} apart")
    assert count > 0 and distance < 1e-11, name
