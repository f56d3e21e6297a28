"""Reads our hexahedra with code_saturne's preprocessor: cells, and faces and cells of every group.

usage: judge_saturne.py {X.hex.h5 FILE.msh|FILE.cgns}...
"""
import re, subprocess, sys

from stage_measures import measures, plain

PREPROCESSOR = "/usr/lib/code_saturne/cs_preprocess"


def groups_of(text):
    """Names or numbers -> faces or cells, from the families that the preprocessor lists at the end."""
    found, names = {}, []
    for line in text.split("Definition of face and cell families")[1].splitlines():
        if line.strip().startswith("Family"):
            names = []
        elif match := re.match(r' +Group "(.*)"$', line):
            names.append(match[1])
        elif match := re.match(" +Number of (cells|boundary faces) +: +([0-9]+)$", line):
            for name in names:
                found[name] = found.get(name, 0) + int(match[2])
    return found


def judge(stage, path):
    run = subprocess.run([PREPROCESSOR, "--no-write", "--grp-cel", "section", path], capture_output=True, text=True)
    assert run.returncode == 0, (path, run.stdout[-500:])
    wanted = {name: count for (_, name), (count, _) in measures(stage).groups.items()}
    if path.endswith(".cgns"):
        wanted = {plain(name): count for name, count in wanted.items()}
    found = {name: count for name, count in groups_of(run.stdout).items() if not name.isdigit()}
    assert found == wanted, (path, found, wanted)


for case in zip(*(iter(sys.argv[1:]),) * 2):
    judge(*case)
print(f"{len(sys.argv[1:]) // 2} files")
