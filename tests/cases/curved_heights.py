#!/usr/bin/python3
"""Whether the nodes on the curve at a distance from a wall are at that distance on the surface, and on it:
curved_heights.py x.quad.h5 NAME cylinder|sphere HEIGHT TOLERANCE. Prints "ok", or what is wrong. The cylinder has the
radius 1 around z, the sphere the radius 1, and there the wall is a circle. Walls are sampled on the curves in space, by
check_regions: code that the tools do not share."""
import sys

import numpy as np

sys.dont_write_bytecode = True
from nodes_on_space_curves import CurvedMesh

path, name, surface, height, tolerance = sys.argv[1:4] + [float(x) for x in sys.argv[4:]]
mesh = CurvedMesh(path)
nodes = mesh.nodes[sorted(mesh.nodes_of[name + "_offset"])]
radius = np.hypot(nodes[:, 0], nodes[:, 1]) if surface == "cylinder" else np.linalg.norm(nodes, axis=1)
if len(nodes) < 20 or abs(radius - 1).max() > 1e-11:
    sys.exit(f"{len(nodes)} nodes, {abs(radius - 1).max():.1e} off the surface")
wall = np.concatenate([c.at(np.linspace(c.begin, c.end, 20001))[0] for c in mesh.curves[name]])
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
