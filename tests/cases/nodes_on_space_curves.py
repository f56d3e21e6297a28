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


class CurvedMesh:
    """A quad mesh on a curved face: `nodes` [n, 3] in space, and by the name of boundaries and interfaces `curves` in
    space and `nodes_of`, the set of the nodes on them."""

    def __init__(self, path):
        with h5py.File(path) as file:
            group = file["face/chart/space_curves"]
            numbers = [np.split(group[key][:], group[f"{key}_offsets"][1:-1]) for key in ("knots", "poles", "weights")]
            names = [name.decode() for name in file["face/curve_names"][:]]
            self.curves, self.nodes_of = {}, {}
            for name, *of_curve in zip(names, group["degree"][:], *numbers):
                self.curves.setdefault(name, []).append(Curve(*of_curve))
            self.nodes, width = file["space_nodes"][:], int(file["order"][()]) + 1
            elems = file["elem_nodes"][:].reshape(-1, width, width)
            for kind in "boundary_edges", "interface_edges":
                if "elem" not in file.get(kind, ()):
                    continue
                for e, s, c in zip(*(file[f"{kind}/{key}"][:] for key in ("elem", "side", "curve"))):
                    side = [elems[e][0, :], elems[e][:, -1], elems[e][-1, ::-1], elems[e][::-1, 0]][s]
                    self.nodes_of.setdefault(names[c], set()).update(map(int, side))


if __name__ == "__main__":
    mesh = CurvedMesh(sys.argv[1])
    x = mesh.nodes
    diameter = np.max(np.linalg.norm(x - x[np.argmax(np.linalg.norm(x - x[0], axis=1))], axis=1))
    for name, nodes in sorted(mesh.nodes_of.items()):
        places = {tuple(np.round(x[n] / diameter * 1e9)) for n in nodes}
        off = np.min([curve.distances(x[list(nodes)]) for curve in mesh.curves[name]], axis=0).max()
        print(name, len(nodes), len(nodes) - len(places), f"{off / diameter:.1e}")
