"""Makes a table of sizes for quadrefine --size-field (formats/size-field.md, "As a table") of a VTU file, as a solver's
error estimator or ParaView writes it. Needs meshio (Debian: python3-meshio).

    python3 -m quadrille.vtu_sizes estimate.vtu --array size -o sizes.csv
"""
import argparse
import os
import sys

import numpy as np

USAGE, BAD_INPUT, NOT_WRITTEN = 2, 3, 4


class Refused(Exception):
    """A mistake in the input. `code`: the exit code."""

    def __init__(self, message, code=BAD_INPUT):
        super().__init__(message)
        self.code = code


def read_mesh(path):
    try:
        from meshio import vtu
    except ImportError:
        raise Refused("meshio is not installed: apt-get install python3-meshio", 1) from None
    try:
        return vtu.read(path)
    except Exception as error:  # meshio has no class of its own for all that it refuses
        raise Refused(f"{path}: cannot be read as VTU: {str(error) or type(error).__name__}") from None


def sized_points(mesh, array):
    """Rows of x, y and size: at the points, or where the array belongs to cells, in the mean of each cell's points."""
    if array in mesh.point_data:
        positions, sizes = mesh.points, mesh.point_data[array]
    elif array in mesh.cell_data:
        positions = np.concatenate([mesh.points[block.data].mean(axis=1) for block in mesh.cells])
        sizes = np.concatenate([np.asarray(values) for values in mesh.cell_data[array]])
    else:
        known = sorted({*mesh.point_data, *mesh.cell_data})
        raise Refused(f"there is no array '{array}'; there are {', '.join(known) or 'none'}: name one by --array", USAGE)
    sizes = np.asarray(sizes, float).reshape(len(positions), -1)
    if sizes.shape[1] != 1:
        raise Refused(f"array '{array}' has {sizes.shape[1]} components: a size is one number")
    rows = np.column_stack([np.asarray(positions, float)[:, :2], sizes])
    wrong = np.flatnonzero(~(np.isfinite(rows).all(axis=1) & (rows[:, 2] > 0)))
    if len(wrong):
        x, y, size = rows[wrong[0]]
        raise Refused(f"the size {size:g} at ({x:g}, {y:g}) must be greater than 0")
    return rows


def write_table(rows, path):
    text = "x,y,size\n" + "".join(f"{x!r},{y!r},{size!r}\n" for x, y, size in rows.tolist())
    if path == "-":
        sys.stdout.write(text)
        return
    partial = f"{path}.{os.getpid()}.part"
    try:
        with open(partial, "w", encoding="utf-8") as file:
            file.write(text)
        os.replace(partial, path)
    except OSError as error:
        raise Refused(f"{path}: cannot be written: {error.strerror}", NOT_WRITTEN) from None


def main(words=None):
    parser = argparse.ArgumentParser(prog="quadrille.vtu_sizes", description=__doc__.partition("\n\n")[0])
    parser.add_argument("vtu", metavar="VTU", help="unstructured grid with sizes at points or in cells")
    parser.add_argument("--array", default="size", help="name of the sizes, in the unit of the positions (default: size)")
    parser.add_argument("-o", "--output", default="-", help="table to write (default: -, standard output)")
    options = parser.parse_args(words)
    try:
        write_table(sized_points(read_mesh(options.vtu), options.array), options.output)
    except Refused as refused:
        print(f"quadrille.vtu_sizes: {refused}", file=sys.stderr)
        return refused.code
    return 0


if __name__ == "__main__":
    sys.exit(main())
