"""Every check of check_regions.py passes on a sound mesh and fails on a damaged one."""
import contextlib
import io
import os
import sys
import tempfile
import unittest
from unittest import mock

import h5py
import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import check_regions  # noqa: E402

BEND = 0.25  # of the interface, to the right
COLUMNS, ROWS = 6, 4  # quads of order 2, half as wide as the unit
WIDTH = 2 * COLUMNS + 1


def bent(x, y):
    """[0, 3] x [0, 2] with x = 1 bent to a parabola; polynomials of degree 2 in each quad."""
    share = x if x < 1 else (3 - x) / 2
    return x + share * BEND * y * (2 - y), y


def line(a, b):
    return 1, [0, 0, 1, 1], [a, b]


def reversed_curve(curve):
    degree, knots, poles = curve
    return degree, [1 - k for k in reversed(knots)], list(reversed(poles))


def curves():
    """A fluid on the left and a solid on the right of curve 1, with a crack, curves 8 and 9."""
    interface = 2, [0, 0, 0, 1, 1, 1], [(1, 0), (1 + 2 * BEND, 1), (1, 2)]
    crack = line(bent(1.5, 1), bent(2.5, 1))
    return [line((0, 0), (1, 0)), interface, line((1, 2), (0, 2)), line((0, 2), (0, 0)),
            line((1, 0), (3, 0)), line((3, 0), (3, 2)), line((3, 2), (1, 2)), reversed_curve(interface),
            crack, reversed_curve(crack)]


def ragged(group, name, rows):
    group[name] = np.concatenate([np.asarray(r, float) for r in rows])
    group[name + "_offsets"] = np.cumsum([0] + [len(r) for r in rows])


def write_face(file):
    face, all_curves = file.create_group("face"), curves()
    face["curves/degree"] = [c[0] for c in all_curves]
    ragged(face["curves"], "knots", [c[1] for c in all_curves])
    ragged(face["curves"], "poles", [c[2] for c in all_curves])
    ragged(face["curves"], "weights", [np.ones(len(c[2])) for c in all_curves])
    names = ["bottom", "wet", "top", "inlet", "bottom", "outer", "top", "wet", "crack", "crack"]
    face["curve_names"] = np.array(names, "S")
    face["loop_offsets"], face["region_loops"] = [0, 4, 8, 10], [0, 1, 3]
    face["region_names"] = np.array(["fluid", "solid"], "S")
    face["partners"] = [-1, 7, -1, -1, -1, -1, -1, 1, 9, 8]
    face["diameter"], face["origin"] = np.hypot(3, 2), [100.0, 0]
    face["periodic_pairs/curves"] = [[0, 2], [4, 6]]
    face["periodic_pairs/angle"], face["periodic_pairs/shift"] = [0.0, 0], [[0.0, 2], [0, 2]]


def node(i, j):
    return j * WIDTH + i


class Parts:
    """The arrays of a mesh, to be damaged."""

    def __init__(self):
        self.nodes = [bent(i / 4, j / 4) for j in range(2 * ROWS + 1) for i in range(WIDTH)]
        below = {}  # the crack's nodes, doubled for the quads below
        for i in range(7, 10):
            below[node(i, 4)] = len(self.nodes)
            self.nodes.append(self.nodes[node(i, 4)])
        self.elems, self.block = [], []
        for j in range(ROWS):
            for i in range(COLUMNS):
                own = [node(2 * i + a, 2 * j + b) for b in range(3) for a in range(3)]
                self.elems.append([below.get(n, n) for n in own] if j == 1 else own)
                self.block.append(0 if i < 2 else 1 + (j >= 2))
        self.block_region = [0, 1, 1]
        self.nodes, self.elems = np.array(self.nodes), np.array(self.elems)
        elem = lambda i, j: j * COLUMNS + i
        rows, up, left = range(ROWS), range(2, 6), range(0, 2)
        self.boundary = (
            [(elem(i, 0), 0, 0) for i in left] + [(elem(i, 3), 2, 2) for i in reversed(left)] +
            [(elem(0, j), 3, 3) for j in reversed(rows)] + [(elem(i, 0), 0, 4) for i in up] +
            [(elem(5, j), 1, 5) for j in rows] + [(elem(i, 3), 2, 6) for i in reversed(up)] +
            [(elem(i, 2), 0, 8) for i in (3, 4)] + [(elem(i, 1), 2, 9) for i in (4, 3)])
        self.interface = [(elem(1, j), 1, 1) for j in rows] + [(elem(2, j), 3, 7) for j in reversed(rows)]

    def write(self, path):
        with h5py.File(path, "w") as file:
            write_face(file)
            file["order"], file["nodes"], file["elem_nodes"] = 2, self.nodes, self.elems.ravel()
            file["elem_block"], file["block_region"] = self.block, self.block_region
            file["block_names"] = np.array(["fluid", "solid", "solid"], "S")
            for name, edges in (("boundary_edges", self.boundary), ("interface_edges", self.interface)):
                for k, key in enumerate(("elem", "side", "curve")):
                    file[f"{name}/{key}"] = np.array(edges, int).reshape(-1, 3)[:, k]


class CheckRegionsTest(unittest.TestCase):
    def faults(self, damage=lambda parts: None, *arguments):
        """The names of the checks that fail, as far as the colon or a bracket."""
        parts = Parts()
        damage(parts)
        with tempfile.TemporaryDirectory() as folder:
            path, output = os.path.join(folder, "x.quad.h5"), io.StringIO()
            parts.write(path)
            with contextlib.redirect_stdout(output), mock.patch.object(sys, "argv", ["check_regions.py", path, *arguments]):
                code = check_regions.main()
        lines = [line for line in output.getvalue().splitlines() if line.startswith(("ok ", "FAULT"))]
        self.assertGreaterEqual(len(lines), 10, output.getvalue())
        faults = {line[6:].split(":")[0].split(" (")[0] for line in lines if line.startswith("FAULT")}
        self.assertEqual(code, 1 if faults else 0)
        return faults

    def test_a_sound_mesh_passes(self):
        self.assertEqual(self.faults(), set())

    def test_areas(self):
        def damage(parts):
            parts.nodes[node(2, 0)] += 0, 1e-8
            parts.nodes[node(2, 8)] += 0, 3e-8
        self.assertEqual(self.faults(damage, "--distance-tolerance", "1", "--pair-tolerance", "1e-7"),
                         {"area of region 0"})

    def test_sides(self):
        def split_a_node(parts):
            parts.nodes = np.vstack([parts.nodes, parts.nodes[node(3, 2)]])
            parts.elems[0 * COLUMNS + 1][7] = len(parts.nodes) - 1
        self.assertEqual(self.faults(split_a_node), {"conformity of sides", "one node in one place"})
        self.assertIn("conformity of sides", self.faults(lambda parts: parts.boundary.pop(0)))

    def test_nodes_in_one_place(self):
        def pinch(parts):
            parts.nodes[node(3, 3)] = parts.nodes[node(4, 3)]
        self.assertIn("one node in one place", self.faults(pinch))

    def test_loops(self):
        def swap(parts):
            parts.interface[0], parts.interface[1] = parts.interface[1], parts.interface[0]
        self.assertEqual(self.faults(swap), {"edges along loops"})

    def test_both_sides(self):
        self.assertEqual(self.faults(lambda parts: parts.interface.pop(0)),
                         {"both sides of interfaces", "edges along loops", "regions"})

        def on_wrong_side(parts):
            parts.interface = [(e, s, 8 - c) for e, s, c in parts.interface]
        self.assertIn("both sides of interfaces", self.faults(on_wrong_side))

    def test_regions(self):
        def swap(parts):
            parts.block_region = [1, 0, 0]
        self.assertIn("regions", self.faults(swap))

        def a_block_across(parts):
            parts.block[2] = 0
        self.assertIn("regions", self.faults(a_block_across))

        def without_interface(parts):
            parts.interface = []
        self.assertIn("regions", self.faults(without_interface))

    def test_boundary(self):
        def damage(parts):
            parts.nodes[node(WIDTH - 1, 3)] += 1e-9, 0
        self.assertEqual(self.faults(damage, "--area-tolerance", "1"), {"boundary nodes on CAD curves"})

    def test_interface(self):
        def damage(parts):
            parts.nodes[node(4, 3)] += 1e-9, 0
        self.assertEqual(self.faults(damage, "--area-tolerance", "1"), {"interface nodes on CAD curves"})
        self.assertEqual(self.faults(damage, "--area-tolerance", "1", "--distance-tolerance", "1e-8"), set())

    def test_cracks(self):
        def apart(parts):
            parts.nodes[node(8, 4)] += 1e-9, 0
        self.assertEqual(self.faults(apart), {"cracks"})

        def closed(parts):
            for elem in (COLUMNS + 3, COLUMNS + 4):
                parts.elems[elem][6:9] = parts.elems[elem + COLUMNS][0:3]
        self.assertIn("cracks", self.faults(closed))

        def with_a_doubled_tip(parts):
            parts.nodes = np.vstack([parts.nodes, parts.nodes[node(6, 4)]])
            parts.elems[COLUMNS + 3][6] = len(parts.nodes) - 1
        self.assertIn("cracks", self.faults(with_a_doubled_tip))

    def test_periodic(self):
        def damage(parts):
            parts.nodes[node(7, 0)] += 1e-9, 0
        self.assertEqual(self.faults(damage), {"periodic nodes"})
        self.assertEqual(self.faults(damage, "--pair-tolerance", "1e-8"), set())

    def test_another_face(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "y.tri.h5")
            for move, expected in ((0, set()), (1e-13, {"curves of both files"})):
                with h5py.File(path, "w") as file:
                    write_face(file)
                    file["face/curves/poles"][0, 0] += move
                parts, mesh = Parts(), os.path.join(folder, "x.quad.h5")
                parts.write(mesh)
                output = io.StringIO()
                arguments = ["check_regions.py", mesh, "--face", path]
                with contextlib.redirect_stdout(output), mock.patch.object(sys, "argv", arguments):
                    code = check_regions.main()
                faults = {line[6:].split(":")[0] for line in output.getvalue().splitlines() if line.startswith("FAULT")}
                self.assertEqual(faults, expected)
                self.assertEqual(code, 1 if expected else 0)

    def test_unreadable(self):
        with contextlib.redirect_stderr(io.StringIO()), mock.patch.object(sys, "argv", ["check_regions.py", "none.h5"]):
            self.assertEqual(check_regions.main(), 3)


if __name__ == "__main__":
    unittest.main()
