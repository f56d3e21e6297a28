import contextlib
import io
import pathlib
import tempfile
import unittest

import numpy as np

from quadrille.vtu_sizes import Refused, main, sized_points


class Grid:
    """What meshio gives of a file: a triangle and a quad."""

    def __init__(self, point_data=None, cell_data=None):
        self.points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0.0]])
        block = lambda cells: type("Block", (), {"data": np.array(cells)})
        self.cells = [block([[1, 4, 2]]), block([[0, 1, 2, 3]])]
        self.point_data, self.cell_data = point_data or {}, cell_data or {}


class SizedPointsTest(unittest.TestCase):
    def test_sizes_at_points_stay_there(self):
        rows = sized_points(Grid({"size": np.arange(1, 6)}), "size")
        self.assertEqual(rows.tolist()[4], [2, 0, 5])

    def test_sizes_of_cells_lie_in_their_middles(self):
        rows = sized_points(Grid(cell_data={"h": [np.array([0.5]), np.array([0.25])]}), "h")
        np.testing.assert_allclose(rows, [[4 / 3, 1 / 3, 0.5], [0.5, 0.5, 0.25]])

    def test_what_is_no_size_is_refused(self):
        for data, array, words in (({"a": np.ones(5)}, "size", "no array 'size'; there are a"),
                                   ({"size": np.ones((5, 2))}, "size", "2 components"),
                                   ({"size": np.array([1, 1, 0, 1, 1])}, "size", r"size 0 at \(1, 1\)")):
            with self.assertRaisesRegex(Refused, words):
                sized_points(Grid(data), array)

    def test_files_that_are_no_vtu_end_with_3_and_write_nothing(self):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stderr(io.StringIO()) as words:
            path = pathlib.Path(folder) / "x.vtu"
            path.write_text("nothing")
            code = main([str(path), "-o", str(path.with_suffix(".csv"))])
            self.assertIn(code, (1, 3))  # 1: there is no meshio
            self.assertFalse(path.with_suffix(".csv").exists())
        self.assertRegex(words.getvalue(), "^quadrille.vtu_sizes: ")
