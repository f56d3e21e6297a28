import unittest

from command_frame import Failure
from outline.point_files import PointFile


def file(*lines):
    return PointFile("points", "\n".join(lines))


class PointFileTest(unittest.TestCase):
    def test_a_point_has_blanks_commas_semicolons_exponents_of_fortran_and_comments(self):
        for line in ("1 -2.5", "1,-2.5", "1 ; -25d-1 # comment", "\t1 -0.25D1"):
            self.assertEqual(file(line).point(1), 1 - 2.5j)
        for line in ("1", "1 2 3", "one 2", "1_0 2", "#"):
            with self.assertRaisesRegex(Failure, "line 1: expected x and y, found"):
                file(line).point(1)

    def test_a_point_is_finite(self):
        for line in ("1 nan", "inf 1", "1"):
            with self.assertRaises(Failure) as raised:
                file("0 0", line).point(2)
            self.assertEqual(raised.exception.code, 3)
            self.assertIn("points: line 2: ", str(raised.exception))

    def test_a_point_may_be_in_any_columns(self):
        self.assertEqual(file("7 1 2").point(1, (2, 1), 3), 2 + 1j)


if __name__ == "__main__":
    unittest.main()
