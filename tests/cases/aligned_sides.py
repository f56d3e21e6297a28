#!/usr/bin/python3
"""How well a mesh follows a curve: aligned_sides.py QUAD ALIGN, the mesh a x.quad.h5, ALIGN a file of one curve
(formats/alignment.md).

Prints the root mean square, in degrees, of the angles between the curve and the nearest of the four directions of each
element (of its map, in its middle) that lies within 0.7 widths of the curve."""
import json
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "pipelines/python"))
import quadrille  # noqa: E402


def nearest_direction(points, width, z):
    """The direction of the curve where it is nearest to z, as a unit number; 0 beyond 0.7 widths."""
    starts, steps = points[:-1], np.diff(points)
    along = np.clip(((z - starts) * steps.conj()).real / abs(steps) ** 2, 0, 1)
    distances = abs(starts + along * steps - z)
    piece = np.argmin(distances)
    return steps[piece] / abs(steps[piece]) if distances[piece] < 0.7 * width else 0


mesh = quadrille.read(sys.argv[1])
curve = json.loads(pathlib.Path(sys.argv[2]).read_text())["curves"][0]
points = np.array(curve["positions"]) @ [1, 1j]
positions, derivatives = mesh.map(np.arange(mesh.num_elements), np.zeros((mesh.num_elements, 2)))
angles = []
for z, along in zip(positions @ [1, 1j], derivatives[:, :, 0] @ [1, 1j]):
    direction = nearest_direction(points, curve["width"], z)
    if direction:
        angles.append(np.angle((along / direction) ** 4) / 4)
print(f"{np.degrees(np.sqrt(np.mean(np.square(angles)))):.3f}")
