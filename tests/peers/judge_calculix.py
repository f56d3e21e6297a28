"""CalculiX on our meshes under one pressure on the surfaces of every name: the stress is the pressure everywhere, by
whatever displacements of a rigid body. A side that is missing, or on the wrong side of its element, would disturb it.

usage: judge_calculix.py {X.quad.h5|X.hex.h5 FILE.inp}...
"""
import os, re, subprocess, sys
from pathlib import Path

import numpy

from stage_measures import measures, plain

JOB = """*INCLUDE, INPUT={path}
*MATERIAL, NAME=M
*ELASTIC
1., 0.3
*SOLID SECTION, ELSET=EALL, MATERIAL=M
{thickness}
*BOUNDARY
{fixed}
*STEP
*STATIC
*DSLOAD
{loads}
*EL PRINT, ELSET=EALL
S
*END STEP
"""
# Stresses xx, yy, zz under a pressure of 1, by the beginning of the type.
STRESSES = {"CPS": (-1, -1, 0), "CPE": (-1, -1, -0.6), "CAX": (-1, -1, -1), "C3D": (-1, -1, -1)}


def mesh(text):
    """Nodes by number, and the type of the elements."""
    rows = re.search(r"\*NODE, NSET=NALL\n((?:[^*].*\n)*)", text)[1].splitlines()
    nodes = {int(row.split(",")[0]): [float(x) for x in row.split(",")[1:]] for row in rows}
    return nodes, re.search(r"\*ELEMENT, TYPE=([A-Z0-9]+)", text)[1]


def fixed(nodes, kind):
    """Conditions that hold a body without force: the triangle of three nodes that are far from a line."""
    numbers, x = numpy.array(list(nodes)), numpy.array(list(nodes.values()))
    if kind.startswith("CAX"):
        return f"{numbers[0]}, 2, 2"
    a, b = x[:, 0].argmin(), x[:, 0].argmax()
    if not kind.startswith("C3D"):
        return f"{numbers[a]}, 1, 2\n{numbers[b]}, 2, 2"
    c = abs(numpy.cross(x[b] - x[a], x - x[a])[:, 2]).argmax()
    return f"{numbers[a]}, 1, 3\n{numbers[b]}, 2, 3\n{numbers[c]}, 3, 3"


def judge(stage, path):
    nodes, kind = mesh(Path(path).read_text())
    names = [plain(name) for name in measures(stage).middles]
    Path("job.inp").write_text(JOB.format(path=path, thickness="" if kind.startswith("C3D") else "1.",
                                          fixed=fixed(nodes, kind), loads="\n".join(f"{name}, P, 1." for name in names))
                               .replace("MATERIAL=M\n\n", "MATERIAL=M\n"))
    Path("job.dat").unlink(missing_ok=True)
    run = subprocess.run(["ccx", "job"], capture_output=True, text=True, env={**os.environ, "OMP_NUM_THREADS": "1"})
    assert run.returncode == 0 and "*ERROR" not in run.stdout, (path, run.stdout[-800:])
    rows = [line.split() for line in Path("job.dat").read_text().splitlines()]
    found = numpy.array([row[2:8] for row in rows if len(row) == 8 and row[0].isdigit()], dtype=float)
    wanted = (*STRESSES[kind[:3]], 0, 0, 0)
    assert len(found) > 0 and abs(found - wanted).max() < 1e-4, (path, kind, len(found), abs(found - wanted).max())


for case in zip(*(iter(sys.argv[1:]),) * 2):
    judge(*case)
print(f"{len(sys.argv[1:]) // 2} files")
