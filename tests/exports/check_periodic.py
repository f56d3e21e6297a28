#!/usr/bin/env python3
"""Checks the periodic sides of exported files: check_periodic.py FILE.msh|FILE.re2 ... Prints the number of pairs of
nodes or sides of each file and how far they are apart, after the file's own motion."""
import struct
import sys


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


for name in sys.argv[1:]:
    pairs, apart = re2(name) if name.endswith(".re2") else msh(name)
    print(f"{name}: {pairs} pairs, at most {apart:.1e} apart")
    assert pairs > 0 and apart < 1e-11, name
