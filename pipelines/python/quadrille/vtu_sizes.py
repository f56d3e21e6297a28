"""Makes a table of sizes for quadrefine --size-field (formats/size-field.md, "As a table"), or of a metric for fieldsolve
--align (formats/alignment.md), of a VTU file, as a solver's error estimator or ParaView writes it. Needs meshio (Debian:
python3-meshio).

    python3 -m quadrille.vtu_sizes estimate.vtu --array size -o sizes.csv
    python3 -m quadrille.vtu_sizes estimate.vtu --array metric -o metric.csv

An array of one component has sizes, one of 3 (m11, m12, m22), 4 (2 x 2) or 9 (3 x 3) a metric. Unless z is 0 at all
points, the table has it, and of a metric of 3 x 3 all components, as curved faces need them.
"""
import argparse
import os
import sys

import numpy as np

USAGE, BAD_INPUT, NOT_WRITTEN = 2, 3, 4
METRIC, SPACE_METRIC = ["m11", "m12", "m22"], ["m11", "m12", "m13", "m22", "m23", "m33"]
# By the number of components: which are m11, m12, m21 and m22.
COMPONENTS = {3: [0, 1, 1, 2], 4: [0, 1, 2, 3], 9: [0, 1, 3, 4]}


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


def values_at_points(mesh, array):
    """Positions, and one row of the array for each: at the points, or where the array belongs to cells, in the mean of
    each cell's points."""
    if array in mesh.point_data:
        positions, values = mesh.points, mesh.point_data[array]
    elif array in mesh.cell_data:
        positions = np.concatenate([mesh.points[block.data].mean(axis=1) for block in mesh.cells])
        values = np.concatenate([np.asarray(values) for values in mesh.cell_data[array]])
    else:
        known = sorted({*mesh.point_data, *mesh.cell_data})
        raise Refused(f"there is no array '{array}'; there are {', '.join(known) or 'none'}: name one by --array", USAGE)
    positions = np.asarray(positions, float)
    dimension = 3 if positions.shape[1] > 2 and positions[:, 2].any() else 2
    return positions[:, :dimension], np.asarray(values, float).reshape(len(positions), -1)


def refuse(rows, dimension, is_right, what):
    """Refuses the first row with a number that is not finite, or that is not right. `dimension`: of its position."""
    wrong = np.flatnonzero(~(np.isfinite(rows).all(axis=1) & is_right))
    if len(wrong):
        row = [f"{value:g}" for value in rows[wrong[0]]]
        raise Refused(what.format(", ".join(row[dimension:]), f"({', '.join(row[:dimension])})"))


def table_of(mesh, array):
    """Names of the columns, and rows: of sizes, or of a metric."""
    positions, values = values_at_points(mesh, array)
    count, dimension = values.shape[1], positions.shape[1]
    axes = ["x", "y", "z"][:dimension]
    if count == 1:
        rows = np.column_stack([positions, values])
        refuse(rows, dimension, values[:, 0] > 0, "the size {} at {} must be greater than 0")
        return axes + ["size"], rows
    if count not in COMPONENTS:
        raise Refused(f"array '{array}' has {count} components: a size has 1, a metric 3 (m11, m12, m22), 4 or 9")
    if dimension == 3 and count == 9:
        tensors = values.reshape(-1, 3, 3)
        tensors = (tensors + tensors.transpose(0, 2, 1)) / 2
        first, second = np.triu_indices(3)
        rows = np.column_stack([positions, tensors[:, first, second]])
        least = np.linalg.eigvalsh(np.nan_to_num(tensors))[:, 0]
        refuse(rows, dimension, least > 0, "the metric {} at {} must be positive definite")
        return axes + SPACE_METRIC, rows
    m11, m12, m21, m22 = values[:, COMPONENTS[count]].T
    mixed = (m12 + m21) / 2
    rows = np.column_stack([positions, m11, mixed, m22])
    refuse(rows, dimension, (m11 > 0) & (m11 * m22 > mixed * mixed), "the metric {} at {} must be positive definite")
    return axes + METRIC, rows


def write_table(names, rows, path):
    text = "".join(",".join(map(str, row)) + "\n" for row in [names, *rows.tolist()])
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
    parser.add_argument("vtu", metavar="VTU", help="unstructured grid with sizes, or a metric, at points or in cells")
    parser.add_argument("--array", default="size", help="name of the sizes, in the unit of the positions, or metric (default: size)")
    parser.add_argument("-o", "--output", default="-", help="table to write (default: -, standard output)")
    options = parser.parse_args(words)
    try:
        write_table(*table_of(read_mesh(options.vtu), options.array), options.output)
    except Refused as refused:
        print(f"quadrille.vtu_sizes: {refused}", file=sys.stderr)
        return refused.code
    return 0


if __name__ == "__main__":
    sys.exit(main())
