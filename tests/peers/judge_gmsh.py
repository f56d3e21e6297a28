"""Reads our MSH files with Gmsh and compares its Jacobians with those of x.quad.h5.

usage: judge_gmsh.py X.quad.h5 REPORT.json FILE.msh...       (REPORT: quadrefine's)
"""
import json, sys

import gmsh, numpy

from quad_file import QuadFile


def ratios_by_gmsh(path):
    """min det J / max det J of each quad (a Bernstein bound of Gmsh's), and the messages on the way."""
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
    # Our elements are written block by block, in their own sequence within a block.
    gmsh.finalize()
    return ratios, groups, said


def main():
    quads, report = QuadFile(sys.argv[1]), json.load(open(sys.argv[2]))
    ours = quads.jacobian_ratios()
    sequence = numpy.argsort(quads.block, kind="stable")
    boundaries, regions = quads.groups()
    wanted = {(1, name): count for name, count in boundaries.items()} | {(2, name): c for name, c in regions.items()}
    for path in sys.argv[3:]:
        ratios, groups, said = ratios_by_gmsh(path)
        complaints = [line for line in said if not line.startswith(("Info", "Progress"))]
        assert not complaints, (path, complaints)
        assert groups == wanted, (path, groups, wanted)
        theirs = numpy.array([ratios[elem] for elem in sorted(ratios)])
        assert len(theirs) == len(ours), (path, len(theirs), len(ours))
        assert theirs.min() > 0, (path, theirs.min())
        worst = numpy.abs(theirs - ours[sequence]).max()
        assert worst < 1e-3, (path, "min det J / max det J differs by", worst)
        assert abs(theirs.min() - report["least_jacobian_ratio"]) < 1e-3, (path, theirs.min(), report)
        print(f"{path}: {len(ours)} quads, least ratio {theirs.min():.6f}, differs by {worst:.1e}")


main()
