#!/usr/bin/python3
"""How far the nodes of a mesh on a curved face are from the curves in space: nodes_on_space_curves.py x.quad.h5.

Prints one line for each name of curves: the name, the number of nodes on it, the number of those that stand twice in
one place (open slits), and the greatest distance of a node from its curve in space, over the diameter. Curves are
evaluated by check_regions, from the numbers of the file: code that the tools do not share."""
import pathlib
import sys

import h5py
import numpy as np

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from check_regions import Curve


def split(group, name):
    return np.split(group[name][:], group[f"{name}_offsets"][1:-1])


with h5py.File(sys.argv[1]) as file:
    face = file["face"]
    group = face["chart/space_curves"]
    numbers = [split(group, name) for name in ("knots", "poles", "weights")]
    curves = [Curve(*of_curve) for of_curve in zip(group["degree"][:], *numbers)]
    names = [n.decode() for n in face["curve_names"][:]]
    x, width = file["space_nodes"][:], int(file["order"][()]) + 1
    elems = file["elem_nodes"][:].reshape(-1, width, width)
    nodes_of = {}
    for kind in "boundary_edges", "interface_edges":
        if kind not in file or "elem" not in file[kind]:
            continue
        for e, s, c in zip(*(file[f"{kind}/{key}"][:] for key in ("elem", "side", "curve"))):
            side = [elems[e][0, :], elems[e][:, -1], elems[e][-1, ::-1], elems[e][::-1, 0]][s]
            nodes_of.setdefault(names[c], set()).update(map(int, side))
diameter = np.max(np.linalg.norm(x - x[np.argmax(np.linalg.norm(x - x[0], axis=1))], axis=1))
for name, nodes in sorted(nodes_of.items()):
    places = {tuple(np.round(x[n] / diameter * 1e9)) for n in nodes}
    off = np.min([curves[c].distances(x[list(nodes)]) for c in range(len(names)) if names[c] == name], axis=0).max()
    print(name, len(nodes), len(nodes) - len(places), f"{off / diameter:.1e}")
