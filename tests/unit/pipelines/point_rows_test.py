import unittest

from command_frame import Failure
from outline.point_files import PointFile
from outline.point_rows import point_loops, read_rows


def rows(*lines):
    return read_rows(PointFile("points", "\n".join(lines)))


class PointRowsTest(unittest.TestCase):
    def test_blank_lines_separate_loops_and_comments_do_not(self):
        found = rows("", "0 0", "# still the first", "1 0", "", "", "2 0", "3 0", "4 0").loops
        self.assertEqual([loop.points for loop in found], [[0, 1], [2, 3, 4]])
        self.assertEqual([loop.lines for loop in found], [[2, 4], [7, 8, 9]])
        self.assertEqual(len(point_loops(PointFile("points", "0 0\n1 1\n"))), 1)

    def test_a_file_without_points_is_refused(self):
        for lines in (["# nothing", ""], ["title"], ["999 999"]):
            with self.assertRaisesRegex(Failure, "^points: there are no points$"):
                rows(*lines)

    def test_headings_are_titles_or_name_the_columns(self):
        self.assertEqual((rows("NACA 4412", "", "0 0", "1 1").title, rows("x,y", "0,0", "1,1").title), ("NACA 4412", ""))
        found = rows('"Y (m)";"n";"X (m)"', "1;7;2", "3;8;4")
        self.assertEqual(found.loops[0].points, [2 + 1j, 4 + 3j])
        self.assertIn("columns 3 and 1 are x and y, as the heading names them", found.notes)
        with self.assertRaisesRegex(Failure, "line 3: expected x and y, found '1 one'"):
            rows("x y", "0 0", "1 one")
        with self.assertRaisesRegex(Failure, "line 2: expected x and y, found '1 one'"):
            rows("x y", "1 one", "0 0")
        self.assertIn("lines 1 to 2 are a heading: '12 per cent'", rows("12 per cent", "x y", "0 0", "1 1").notes)

    def test_a_third_column_holds_zeros(self):
        found = rows("0 0 0", "1 0 0.0", "1 1 -0")
        self.assertEqual((found.loops[0].points, found.notes), ([0, 1, 1 + 1j], ["the third column, zeros, is left out"]))
        with self.assertRaisesRegex(Failure, "line 2: .* its third number is not 0"):
            rows("0 0 0", "1 0 0.1", "1 1 0")
        with self.assertRaisesRegex(Failure, "line 2: expected x and y, found '1 0 0'"):
            rows("0 0", "1 0 0", "1 1")

    def test_rows_of_999_separate_loops_near_the_origin_and_a_region_of_a_grid_is_left_out(self):
        found = rows("two", "-1 2 -1 1", "0 0", "1 0", "999.0 999.0", "0 5", "1 5")
        self.assertEqual([loop.points for loop in found.loops], [[0, 1], [5j, 1 + 5j]])
        self.assertEqual(len(found.notes), 3)
        self.assertEqual(len(rows("0 0", "999 0", "999 999", "0 999").loops), 1)

    def test_the_rounding_error_is_half_a_unit_of_the_last_decimal(self):
        for lines, rounding in ((["0 0", "1 0.25"], 0.005), (["0 0", "1 3"], 0.5), (["1e-3 0", "2.5E-3 0"], 0.5e-4),
                                (["0.1234567890123456 0"], 0.0)):
            self.assertAlmostEqual(rows(*lines).rounding, rounding, 15)


if __name__ == "__main__":
    unittest.main()
