#!/usr/bin/python3
"""Measures whether the mesh of a curved face has the mirror planes of its boundary: none of our C++ code is used.

    tests/stress/curved_symmetry.py MESH.quad.h5...

Prints a line of JSON for each mesh: the number of mirror planes of its boundary in space (planes between two ends of
curves in which all curves are their own images within 1e-6 diameters), and `off`, the greatest distance of the image
of a node from the nearest node, in diameters: null where there is no such plane. Ends with 1 where `off` exceeds 1e-6.
"""
import itertools
import json
import pathlib
import sys

import h5py
import numpy
import scipy.interpolate
import scipy.spatial

SAME = 1e-6  # diameters
SAMPLES = 400  # along a curve, of which the chords are nearer than SAME * 100


def curve_points(group):
    """Points of each curve, and its ends: arrays [curve, sample, 3], [end, 3]."""
    knots, poles, weights = group["knots"][:], group["poles"][:], group["weights"][:]
    of_knots, of_poles = group["knots_offsets"][:], group["poles_offsets"][:]
    points = []
    for c, degree in enumerate(group["degree"][:]):
        t = knots[of_knots[c]:of_knots[c + 1]]
        some, w = slice(of_poles[c], of_poles[c + 1]), weights[of_poles[c]:of_poles[c + 1], None]
        spline = scipy.interpolate.BSpline(t, numpy.hstack([poles[some] * w, w]), int(degree))
        at = spline(numpy.linspace(t[0], t[-1], SAMPLES))
        points.append(at[:, :3] / at[:, 3:])
    return numpy.array(points), numpy.vstack([[p[0], p[-1]] for p in points])


def image(points, plane):
    middle, normal = plane
    return points - 2 * numpy.einsum("...i,i->...", points - middle, normal)[..., None] * normal


def greatest_distance(points, others):
    return float(scipy.spatial.cKDTree(others).query(points)[0].max())


def distance_from_polygons(points, curves):
    """The greatest distance of points from the polygons through the samples of curves."""
    starts, steps = curves[:, :-1].reshape(-1, 3), (curves[:, 1:] - curves[:, :-1]).reshape(-1, 3)
    middles = starts + steps / 2
    near = scipy.spatial.cKDTree(middles).query(points, k=min(4, len(middles)))[1]
    rest = points[:, None] - starts[near]
    part = numpy.clip((rest * steps[near]).sum(-1) / (steps[near]**2).sum(-1), 0, 1)
    return float(numpy.linalg.norm(rest - part[..., None] * steps[near], axis=-1).min(1).max())


def mirror_planes(curves, ends, diameter):
    """Planes between two ends whose images of the ends, the middles and the curves are on the boundary."""
    planes = []
    flat = curves[:, 5::37].reshape(-1, 3)
    sag = max(numpy.linalg.norm(c[1:-1] - (c[:-2] + c[2:]) / 2, axis=1).max() for c in curves)
    for a, b in itertools.combinations(range(len(ends)), 2):
        length = numpy.linalg.norm(ends[b] - ends[a])
        if length < SAME * diameter:
            continue
        plane = ((ends[a] + ends[b]) / 2, (ends[b] - ends[a]) / length)
        if greatest_distance(image(ends, plane), ends) > SAME * diameter:
            continue
        if distance_from_polygons(image(flat, plane), curves) > SAME * diameter + sag:
            continue
        if not any(abs(plane[1] @ other[1]) > 1 - SAME for other in planes):
            planes.append(plane)
    return planes


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    worst = 0
    for path in map(pathlib.Path, sys.argv[1:]):
        with h5py.File(path) as file:
            curves, ends = curve_points(file["face/chart/space_curves"])
            nodes = file["space_nodes"][:]
        diameter = float(numpy.linalg.norm(numpy.ptp(nodes, axis=0)))
        planes = mirror_planes(curves, ends, diameter)
        off = max((greatest_distance(image(nodes, plane), nodes) for plane in planes), default=None)
        print(json.dumps({"mesh": path.name, "planes": len(planes), "off": off and off / diameter}))
        worst = max(worst, (off or 0) / diameter)
    return 1 if worst > SAME else 0


if __name__ == "__main__":
    sys.exit(main())
