import csv
import io
import pathlib
import tempfile
import unittest

from many_shapes.result_table import csv_text, html_text, write_tables, write_whole
from many_shapes.shape_results import Results

REPORT = {"blocks": 4, "quads": 10, "irregular_nodes": 2, "least_scaled_jacobian": 0.51234,
          "greatest_edge_ratio": {"value": 3.0}, "warnings": [{"code": "W-X-1"}]}
RESULTS = Results("out")
ROWS = [RESULTS.new_row("a, b.step", {}, 0, 0.25, "", REPORT),
        RESULTS.new_row("<c>.step", {}, 1, 0.5, 'no "layout"', None)]


class TableTest(unittest.TestCase):
    def test_csv_has_a_line_for_each_shape(self):
        good, bad = csv.DictReader(io.StringIO(csv_text(ROWS)))
        self.assertEqual([good[key] for key in ("shape", "least_scaled_jacobian", "warnings")],
                         ["a, b.step", "0.51234", "W-X-1"])
        self.assertEqual((bad["exit_code"], bad["quads"], bad["message"]), ("1", "", 'no "layout"'))

    def test_csv_has_no_formulas(self):
        row = RESULTS.new_row("=1+1.step", {}, 1, 0.5, "@SUM(A1)", None)
        (read,) = csv.DictReader(io.StringIO(csv_text([row])))
        self.assertEqual((read["shape"], read["message"], read["cpu_seconds"]), ("'=1+1.step", "'@SUM(A1)", "0.5"))

    def test_html_escapes_links_meshes_and_begins_with_failures(self):
        text = html_text(ROWS, lambda row: "a, b.msh", lambda row: "a, b.svg" if row["exit_code"] == 0 else None)
        self.assertIn('<a href="a%2C%20b.msh"><span class="name" title="a, b.step">a, b.step</span></a>', text)
        self.assertIn('<td></td><td><span class="name" title="&lt;c&gt;.step">&lt;c&gt;.step</span></td>', text)
        self.assertEqual(text.count('<img src="a%2C%20b.svg" alt="" loading="lazy">'), 1)
        self.assertLess(text.index("&lt;c&gt;"), text.index("a, b.step</span></a>"))
        self.assertIn("2 shapes: 1 meshes, 1 failures; 10 quads, 0.8 CPU seconds", text)

    def test_files_are_replaced_and_nothing_else_is_left(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder)
            write_whole(path / "table.csv", "old")
            write_tables(Results(path))
            self.assertEqual(sorted(file.name for file in path.iterdir()), ["table.csv", "table.html"])
            self.assertTrue((path / "table.csv").read_text().startswith("shape,exit_code,"))
            write_whole(path / "table.csv", "a\udcff.step")
            self.assertEqual((path / "table.csv").read_text(), "a\\udcff.step")
            with self.assertRaises(OSError):
                write_whole(path, "")
            self.assertEqual(len(list(path.iterdir())), 2)


if __name__ == "__main__":
    unittest.main()
