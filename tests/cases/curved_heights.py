#!/usr/bin/python3
"""Whether the nodes on the curve at a distance from a wall are at that distance on the surface, and on it:
curved_heights.py x.quad.h5 NAME cylinder|sphere HEIGHT TOLERANCE. Prints "ok", or what is wrong. The cylinder has the
radius 1 around z, the sphere the radius 1, and there the wall is a circle. Walls are sampled on the curves in space, by
check_regions: code that the tools do not share."""
import pathlib
import sys

import h5py
import numpy as np

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from check_regions import Curve

path, name, surface, height, tolerance = sys.argv[1:4] + [float(x) for x in sys.argv[4:]]


def split(group, key):
    return np.split(group[key][:], group[f"{key}_offsets"][1:-1])


with h5py.File(path) as file:
    group = file["face/chart/space_curves"]
    numbers = [split(group, key) for key in ("knots", "poles", "weights")]
    curves = [Curve(*of_curve) for of_curve in zip(group["degree"][:], *numbers)]
    names = [n.decode() for n in file["face/curve_names"][:]]
    x, width = file["space_nodes"][:], int(file["order"][()]) + 1
    elems = file["elem_nodes"][:].reshape(-1, width, width)
    on_offset = set()
    for e, s, c in zip(*(file[f"interface_edges/{key}"][:] for key in ("elem", "side", "curve"))):
        if names[c] == name + "_offset":
            on_offset |= set(map(int, [elems[e][0, :], elems[e][:, -1], elems[e][-1, ::-1], elems[e][::-1, 0]][s]))
nodes = x[sorted(on_offset)]
radius = np.hypot(nodes[:, 0], nodes[:, 1]) if surface == "cylinder" else np.linalg.norm(nodes, axis=1)
if len(nodes) < 20 or abs(radius - 1).max() > 1e-11:
    sys.exit(f"{len(nodes)} nodes, {abs(radius - 1).max():.1e} off the surface")
wall = np.concatenate([curves[c].at(np.linspace(curves[c].begin, curves[c].end, 20001))[0] for c in range(len(names)) if names[c] == name])
if surface == "cylinder":
    def unrolled(p):
        return np.stack([np.arctan2(p[:, 1], p[:, 0]), p[:, 2]], 1)

    a, b = unrolled(wall)[:-1], unrolled(wall)[1:]
    along = b - a
    length = (along ** 2).sum(1)
    measured = []
    for q in unrolled(nodes):
        t = np.clip(((q - a) * along).sum(1) / length, 0, 1)
        measured.append(np.linalg.norm(a + t[:, None] * along - q, axis=1).min())
else:
    axis = np.linalg.svd(wall - wall.mean(0))[2][2]
    axis *= np.sign(axis @ wall.mean(0))
    measured = np.arccos(nodes @ axis) - np.arccos((wall @ axis).mean())
off = max(abs(np.array(measured) - height))
print("ok" if off <= tolerance else f"heights are off by {off:.2e}")
