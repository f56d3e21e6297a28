"""What Exodus' own library reads of our files (read_exodus.c), against the stage files; and NetCDF's names.

usage: judge_exodus.py READ_EXODUS {X.quad.h5|X.hex.h5 FILE.exo}...
"""
import subprocess, sys

import netCDF4, numpy

from stage_measures import measures, plain, sorted_rows

TYPES = {(2, 1): "QUAD4", (2, 2): "QUAD9", (3, 1): "HEX8", (3, 2): "HEX27"}


def files(text):
    """File by file: elements, {block: (type, elements)}, {side set: means of corners}."""
    found = {}
    for line in text.splitlines():
        what, name, *rest = line.split()
        if what == "file":
            dim, (elements, blocks, sides) = int(rest[0]), found.setdefault(name, (int(rest[1]), {}, {}))
        elif what == "block":
            blocks[name] = rest[0], int(rest[1])
        elif what == "sides":
            sides[name] = sorted_rows(numpy.array(rest, dtype=float).reshape(-1, dim))
    return found


def names_by_netcdf(path, variable):
    with netCDF4.Dataset(path) as file:
        file.set_auto_mask(False)
        return {b"".join(row).rstrip(b"\0").decode() for row in file[variable][:]}


def judge(stage, path, found):
    wanted, (elements, blocks, sides) = measures(stage), found[path]
    dim, parts = wanted.dimension, (wanted.order + 1) // 2
    kind = TYPES[dim, min(wanted.order, 2)]
    regions = {plain(name): (kind, count * parts**dim) for (of, name), (count, _) in wanted.groups.items() if of == dim}
    assert blocks == regions and elements == sum(count for _, count in blocks.values()), (path, blocks, regions)
    assert set(sides) == set(map(plain, wanted.middles)), (path, set(sides), set(wanted.middles))
    for name, rows in wanted.middles.items():
        there = sides[plain(name)]
        assert len(there) == len(rows) * parts ** (dim - 1), (path, name, len(there))
        off = numpy.abs(there - rows).max() if parts == 1 else 0
        assert off < 1e-12 * numpy.abs(wanted.corners).max(), (path, name, off)
    assert names_by_netcdf(path, "ss_names") == set(sides) and names_by_netcdf(path, "eb_names") == set(blocks), path


cases = list(zip(*(iter(sys.argv[2:]),) * 2))
read = subprocess.run([sys.argv[1], *(path for _, path in cases)], capture_output=True, text=True)
assert read.returncode == 0 and not read.stderr, read.stderr
found = files(read.stdout)
for case in cases:
    judge(*case, found)
print(f"{len(cases)} files")
