"""Reads our MSH files with Gmsh and compares its Jacobians with those of x.quad.h5.

usage: judge_gmsh.py {X.quad.h5 REPORT.json FILE.msh FILE.22.msh}...       (REPORT: quadrefine's)
"""
import json, sys

import gmsh, numpy

from quad_file import QuadFile


# The plugin stops where its bounds of min and max det J are within 1e-3 of the truth.
PLUGIN_TOLERANCE = 2.1e-3


def least_by_shape_functions(ratios):
    """min det J / max det J, from samples, of the worst element among those that the plugin cannot tell from it."""
    at = -numpy.cos(numpy.linspace(0, numpy.pi, 31))
    points = numpy.array([(a, b, 0) for b in at for a in at]).ravel()
    near = [elem for elem in ratios if ratios[elem] <= min(ratios.values()) + PLUGIN_TOLERANCE]
    dets = (gmsh.model.mesh.getJacobian(elem, points)[1] for elem in near[:100])
    return min(det.min() / det.max() for det in dets)


def ratios_by_gmsh(path):
    """What Gmsh says of a file: min det J / max det J of each quad (the plugin's bounds), the least of them by Gmsh's
    shape functions, elements by group, messages on the way."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.logger.start()
    gmsh.open(path)
    gmsh.plugin.setNumber("AnalyseMeshQuality", "JacobianDeterminant", 1)
    gmsh.plugin.setNumber("AnalyseMeshQuality", "CreateView", 1)
    gmsh.plugin.run("AnalyseMeshQuality")
    said = gmsh.logger.get()
    gmsh.logger.stop()
    # One view holds det J's minima, the other the ratios.
    views = {gmsh.option.getString(f"View[{gmsh.view.getIndex(tag)}].Name"): tag for tag in gmsh.view.getTags()}
    _, elems, values, _, _ = gmsh.view.getModelData(next(views[name] for name in views if "minJ/maxJ" in name), 0)
    ratios = dict(zip(map(int, elems), (float(v[0]) for v in values)))
    groups = {}
    for dim, tag in gmsh.model.getPhysicalGroups():
        key = dim, gmsh.model.getPhysicalName(dim, tag)
        for entity in gmsh.model.getEntitiesForPhysicalGroup(dim, tag):
            groups[key] = groups.get(key, 0) + sum(len(t) for t in gmsh.model.mesh.getElements(dim, entity)[1])
    least = least_by_shape_functions(ratios)
    gmsh.finalize()
    return ratios, least, groups, said


def judge(stage, report, *paths):
    quads, report = QuadFile(stage), json.load(open(report))
    ours = quads.jacobian_ratios()
    sequence = numpy.argsort(quads.block, kind="stable")  # elements are written block by block
    boundaries, regions = quads.groups()
    wanted = {(1, name): count for name, count in boundaries.items()} | {(2, name): c for name, c in regions.items()}
    for path in paths:
        ratios, least, groups, said = ratios_by_gmsh(path)
        complaints = [line for line in said if not line.startswith(("Info", "Progress"))]
        assert not complaints, (path, complaints)
        assert groups == wanted, (path, groups, wanted)
        theirs = numpy.array([ratios[elem] for elem in sorted(ratios)])
        assert len(theirs) == len(ours), (path, len(theirs), len(ours))
        assert theirs.min() > 0, (path, theirs.min())
        above = theirs - ours[sequence]
        assert above.min() > -PLUGIN_TOLERANCE and above.max() < 1e-4, (path, above.min(), above.max())
        assert abs(least - report["least_jacobian_ratio"]) < 1e-3, (path, least, report["least_jacobian_ratio"])
        print(f"{path}: {len(ours)} quads, least ratio {least:.6f}, plugin {above.min():.1e} to {above.max():.1e}")


for case in zip(*(iter(sys.argv[1:]),) * 4):
    judge(*case)
