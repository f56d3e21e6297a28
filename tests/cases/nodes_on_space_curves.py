#!/usr/bin/python3
"""How far the nodes of a mesh on a curved face are from the curves in space: nodes_on_space_curves.py x.quad.h5.

Prints one line for each name of curves: the name, the number of nodes on it, the number of those that stand twice in
one place (open slits), and the greatest distance of a node from its curve in space, over the diameter. Curves are
evaluated here, from the numbers of the file, by code that the tools do not share."""
import sys

import h5py
import numpy as np


def split(group, name):
    return np.split(group[name][:], group[f"{name}_offsets"][1:-1])


def basis(knots, degree, t):
    last = max(i for i in range(len(knots) - 1) if knots[i] < knots[i + 1])
    span = np.clip(np.searchsorted(knots, t, side="right") - 1, 0, last)
    values = np.zeros((len(t), len(knots) - 1))
    values[np.arange(len(t)), span] = 1
    for p in range(1, degree + 1):
        n = len(knots) - 1 - p
        low, high = knots[p:p + n] - knots[:n], knots[p + 1:p + 1 + n] - knots[1:n + 1]
        left = (t[:, None] - knots[:n]) / np.where(low > 0, low, np.inf)
        right = (knots[p + 1:p + 1 + n] - t[:, None]) / np.where(high > 0, high, np.inf)
        values = left * values[:, :n] + right * values[:, 1:n + 1]
    return values


def distance(curve, x):
    """Ever finer samples around the nearest one of many."""
    degree, knots, poles, weights = curve
    homogeneous = np.column_stack([poles * weights[:, None], weights])

    def at(t):
        h = basis(knots, degree, t) @ homogeneous
        return h[:, :3] / h[:, 3:]

    t = np.unique(np.concatenate([np.linspace(a, b, 65) for a, b in zip(knots[:-1], knots[1:]) if a < b]))
    step = np.max(np.diff(t))
    for _ in range(12):
        off = np.linalg.norm(at(t) - x, axis=1)
        best = t[np.argmin(off)]
        t, step = np.clip(np.linspace(best - step, best + step, 65), knots[0], knots[-1]), step / 16
    return off.min()


with h5py.File(sys.argv[1]) as file:
    face = file["face"]
    group = face["chart/space_curves"]
    curves = list(zip(group["degree"][:], *(split(group, name) for name in ("knots", "poles", "weights"))))
    names = [n.decode() for n in face["curve_names"][:]]
    x, width = file["space_nodes"][:], int(file["order"][()]) + 1
    elems = file["elem_nodes"][:].reshape(-1, width, width)
    nodes_of = {}
    for kind in "boundary_edges", "interface_edges":
        if kind not in file or "elem" not in file[kind]:
            continue
        for e, s, c in zip(*(file[f"{kind}/{key}"][:] for key in ("elem", "side", "curve"))):
            side = [elems[e][0, :], elems[e][:, -1], elems[e][-1, ::-1], elems[e][::-1, 0]][s]
            nodes_of.setdefault(names[c], {}).update({int(n): c for n in side})
diameter = np.max(np.linalg.norm(x - x[np.argmax(np.linalg.norm(x - x[0], axis=1))], axis=1))
for name, nodes in sorted(nodes_of.items()):
    places = {tuple(np.round(x[n] / diameter * 1e9)) for n in nodes}
    off = max(min(distance(curves[d], x[n]) for d in {c} | {d for d in range(len(names)) if names[d] == name})
              for n, c in nodes.items())
    print(name, len(nodes), len(nodes) - len(places), f"{off / diameter:.1e}")
