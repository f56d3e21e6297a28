import unittest

from command_frame import Failure
from outline import point_files
from outline.point_files import PointFile


def file(*lines):
    return PointFile("points", "\n".join(lines))


class PointFileTest(unittest.TestCase):
    def test_a_pair_has_blanks_commas_semicolons_exponents_of_fortran_and_comments(self):
        for line in ("1 -2.5", "1,-2.5", "1 ; -25d-1 # comment", "\t1 -0.25D1"):
            self.assertEqual(file(line).pair(1), 1 - 2.5j)
        for line in ("1", "1 2 3", "one 2", "1_0 2", "#"):
            self.assertIsNone(file(line).pair(1))

    def test_a_point_is_finite(self):
        for line in ("1 nan", "inf 1", "1"):
            with self.assertRaises(Failure) as raised:
                file("0 0", line).point(2)
            self.assertEqual(raised.exception.code, 3)
            self.assertIn("points: line 2: ", str(raised.exception))


class PointLoopsTest(unittest.TestCase):
    def test_blank_lines_separate_loops_and_comments_do_not(self):
        found = point_files.point_loops(file("", "0 0", "# still the first", "1 0", "", "", "2 0", "3 0", "4 0"))
        self.assertEqual([loop.points for loop in found], [[0, 1], [2, 3, 4]])
        self.assertEqual([loop.lines for loop in found], [[2, 4], [7, 8, 9]])

    def test_a_file_without_points_is_refused(self):
        with self.assertRaisesRegex(Failure, "^points: there are no points$"):
            point_files.point_loops(file("# nothing", ""))


class FormatTest(unittest.TestCase):
    def test_the_first_lines_tell_the_format(self):
        self.assertEqual(point_files.detect_format(file("# comment", "0 0", "1 1")), "points")
        self.assertEqual(point_files.detect_format(file("title", "1 0", "0 0")), "selig")
        self.assertEqual(point_files.detect_format(file("title", "3. 2.", "", "0 0")), "lednicer")
        self.assertEqual(point_files.detect_format(file("title", "1.5 2", "0 0")), "selig")
        self.assertEqual(point_files.detect_format(file()), "points")


class AerofoilTest(unittest.TestCase):
    def test_both_formats_give_the_same_loop_but_only_one_tells_the_nose(self):
        selig, title, nose = point_files.aerofoil(file("wing", "1 0", "0.5 0.1", "0 0", "0.5 -0.1"), False)
        self.assertEqual((title, nose), ("wing", None))
        lines = "wing", "3 2", "0 0", "0.5 0.1", "1 0", "0 0", "0.5 -0.1"
        lednicer, title, nose = point_files.aerofoil(file(*lines), True)
        self.assertEqual((title, nose), ("wing", 2))
        self.assertEqual(lednicer.points, selig.points)
        self.assertEqual(lednicer.lines, [5, 4, 3, 7])

    def test_sides_that_do_not_share_a_nose_keep_both_points(self):
        loop, _, nose = point_files.aerofoil(file("2 2", "0 0.1", "1 0", "0 -0.1", "0.9 -0.1"), True)
        self.assertEqual(loop.points, [1, 0.1j, -0.1j, 0.9 - 0.1j])
        self.assertEqual(nose, 1)

    def test_the_number_of_points_must_be_the_announced_one(self):
        with self.assertRaisesRegex(Failure, "line 2: expected 2 \\+ 2 points, found 3"):
            point_files.aerofoil(file("wing", "2 2", "0 0", "1 0", "0 0"), True)
        with self.assertRaisesRegex(Failure, "line 2: expected the numbers of points"):
            point_files.aerofoil(file("wing", "0 0.5", "1 0"), True)
        with self.assertRaisesRegex(Failure, "there are no points"):
            point_files.aerofoil(file("wing"), False)
