import contextlib
import io
import pathlib
import tempfile
import unittest

import numpy as np

from quadrille.vtu_sizes import Refused, main, table_of, write_table


class Grid:
    """What meshio gives of a file: a triangle and a quad."""

    def __init__(self, point_data=None, cell_data=None):
        self.points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0.0]])
        block = lambda cells: type("Block", (), {"data": np.array(cells)})
        self.cells = [block([[1, 4, 2]]), block([[0, 1, 2, 3]])]
        self.point_data, self.cell_data = point_data or {}, cell_data or {}


class TableOfTest(unittest.TestCase):
    def test_sizes_at_points_stay_there(self):
        names, rows = table_of(Grid({"size": np.arange(1, 6)}), "size")
        self.assertEqual(names, ["x", "y", "size"])
        self.assertEqual(rows.tolist()[4], [2, 0, 5])

    def test_sizes_of_cells_lie_in_their_middles(self):
        _, rows = table_of(Grid(cell_data={"h": [np.array([0.5]), np.array([0.25])]}), "h")
        np.testing.assert_allclose(rows, [[4 / 3, 1 / 3, 0.5], [0.5, 0.5, 0.25]])

    def test_metrics_of_3_4_and_9_components_are_the_same_table(self):
        metric = np.tile([4, 1, 2], (5, 1))
        for columns in ([0, 1, 2], [0, 1, 1, 2]):
            names, rows = table_of(Grid({"m": metric[:, columns]}), "m")
            self.assertEqual(names, ["x", "y", "m11", "m12", "m22"])
            self.assertEqual(rows[4].tolist(), [2, 0, 4, 1, 2])
        in_space = np.zeros((5, 3, 3))
        in_space[:] = [[4, 0.5, 0], [1.5, 2, 0], [0, 0, 7]]
        for tensors in (in_space, in_space.reshape(5, 9)):
            self.assertEqual(table_of(Grid({"m": tensors}), "m")[1][4].tolist(), [2, 0, 4, 1, 2])

    def test_metrics_of_cells_lie_in_their_middles(self):
        _, rows = table_of(Grid(cell_data={"m": [np.array([[2, 0, 1]]), np.array([[1, 0, 3]])]}), "m")
        np.testing.assert_allclose(rows, [[4 / 3, 1 / 3, 2, 0, 1], [0.5, 0.5, 1, 0, 3]])

    def test_points_off_the_plane_keep_z_and_whole_tensors(self):
        grid = Grid({"size": np.arange(1, 6), "m": np.tile([[4, 1, 0.5], [1, 3, 0], [0.5, 0, 7]], (5, 1, 1))})
        grid.points[4, 2] = 0.5
        names, rows = table_of(grid, "size")
        self.assertEqual((names, rows[4].tolist()), (["x", "y", "z", "size"], [2, 0, 0.5, 5]))
        names, rows = table_of(grid, "m")
        self.assertEqual(names, ["x", "y", "z", "m11", "m12", "m13", "m22", "m23", "m33"])
        self.assertEqual(rows[4].tolist(), [2, 0, 0.5, 4, 1, 0.5, 3, 0, 7])
        grid.point_data["m"][4, 0, 0] = -1
        with self.assertRaisesRegex(Refused, r"at \(2, 0, 0.5\) must be positive definite"):
            table_of(grid, "m")

    def test_a_table_has_a_heading_and_numbers_with_all_digits(self):
        with contextlib.redirect_stdout(io.StringIO()) as written:
            write_table(*table_of(Grid({"m": np.tile([1 / 3, 0, 1e9], (5, 1))}), "m"), "-")
        self.assertEqual(written.getvalue().splitlines()[:2],
                         ["x,y,m11,m12,m22", "0.0,0.0,0.3333333333333333,0.0,1000000000.0"])

    def test_what_is_no_size_is_refused(self):
        for data, array, words in (({"a": np.ones(5)}, "size", "no array 'size'; there are a"),
                                   ({"size": np.ones((5, 2))}, "size", "2 components"),
                                   ({"size": np.array([1, 1, 0, 1, 1])}, "size", r"size 0 at \(1, 1\)"),
                                   ({"m": np.tile([1, 2, 3], (5, 1))}, "m", r"metric 1, 2, 3 at \(0, 0\) .* definite"),
                                   ({"m": np.full((5, 4), np.nan)}, "m", "must be positive definite")):
            with self.assertRaisesRegex(Refused, words):
                table_of(Grid(data), array)

    def test_files_that_are_no_vtu_end_with_3_and_write_nothing(self):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stderr(io.StringIO()) as words:
            path = pathlib.Path(folder) / "x.vtu"
            path.write_text("nothing")
            code = main([str(path), "-o", str(path.with_suffix(".csv"))])
            self.assertIn(code, (1, 3))  # 1: there is no meshio
            self.assertFalse(path.with_suffix(".csv").exists())
        self.assertRegex(words.getvalue(), "^quadrille.vtu_sizes: ")
