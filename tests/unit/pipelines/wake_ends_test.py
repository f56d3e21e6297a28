import pathlib
import tempfile
import unittest

from command_frame import Failure
from outline.build import Settings, build_outline
from outline.point_files import PointFile

WING = "wing\n1 0\n0.5 0.1\n0 0\n0.5 -0.1\n1 0\n"
BLUNT = "wing\n1 0.01\n0.5 0.1\n0 0\n0.5 -0.1\n1 -0.01\n"
SQUARE = "0 0\n1 0\n1 1\n0 1\n"
TWO = SQUARE + "\n3 0\n4 0\n4 1\n3 1\n"


def with_wake(body, points, far_field=("cgrid", 10.0), **settings):
    """(points where edges of the wake meet, warnings)."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "wake.txt"
        path.write_text(points)
        settings["format"] = "selig" if body.startswith("wing") else "auto"
        outline = build_outline(PointFile("points", body), Settings(far_field=far_field, wake=str(path), **settings))
    return [edge.start for edge in outline.embedded] + [outline.embedded[-1].end], outline.warnings


class WakeEndsTest(unittest.TestCase):
    def test_a_wake_from_inside_begins_where_it_leaves_the_body(self):
        for body, points, start in ((WING, "0.5 0\n11 0\n", 1), (BLUNT, "0 0\n0.5 0\n11 0\n", 1),
                                    (BLUNT, "0.99998 0\n11 0\n", 1)):
            ends, warnings = with_wake(body, points)
            self.assertAlmostEqual(ends[0], start)
            self.assertEqual((ends[1:], warnings), ([11], []))
        ends, _ = with_wake(SQUARE, "0.5 0.5\n2 0.5\n5 3\n20 3\n", ("box", 8.0))
        self.assertAlmostEqual(ends[0], 1 + 0.5j)

    def test_a_wake_that_crosses_a_body_is_refused(self):
        for body, points in ((WING, "0.3 0.5\n0.4 -0.5\n11 -1\n"), (TWO, "0.5 0.5\n20 0.5\n"), (TWO, "1 0.5\n20 0.5\n"),
                             (SQUARE, "-1 0.5\n9 0.5\n")):
            with self.assertRaisesRegex(Failure, r"wake.txt: the wake crosses the body from \(") as caught:
                with_wake(body, points)
            self.assertEqual(caught.exception.code, 3)
        with self.assertRaisesRegex(Failure, "line 2: the wake ends inside the body"):
            with_wake(SQUARE, "0.2 0.5\n0.7 0.5\n")
        # Only the curve: it turns at the square's corner.
        with self.assertRaisesRegex(Failure, "the smooth curve through the points of the wake crosses the body"):
            with_wake(SQUARE, "1 0.5\n1.0001 0.95\n1.1 1.2\n5 5\n")

    def test_small_gaps_are_closed_without_a_kink(self):
        ends, warnings = with_wake(SQUARE, "1.04 0.5\n4 0.5\n12.38 0.5\n", ("box", 8.0))
        self.assertAlmostEqual(ends[0], 1 + 0.5j)
        self.assertEqual(len(ends), 2)
        ends, warnings = with_wake(WING, "1.01 0.001\n4 0\n10.98 0\n")
        self.assertEqual((ends[0], warnings), (1, []))  # the tip, not a part of the side that is as near
        self.assertAlmostEqual(ends[1], 11)
        ends, _ = with_wake(WING, "0.5 0.13\n3 1\n11 1\n")
        self.assertAlmostEqual(ends[0], 0.5 + 0.1j, delta=0.02)

    def test_a_wake_that_falls_short_is_continued_with_a_warning(self):
        ends, (begun, ended) = with_wake(WING, "3 1\n6 1\n")
        self.assertEqual(ends[0], 1)
        self.assertAlmostEqual(ends[-1], 11 + 1j)
        self.assertRegex(begun, r"wake.txt: the wake begins at \(3, 1\), 2.236 away from the body: it is continued to \(1, 0")
        self.assertRegex(ended, r"the wake ends at \(6, 1\), 5 before the far field: .* to \(11, 1\)")
        ends, warnings = with_wake(WING, "2 0\n6 0\n", chord=2.0)
        self.assertEqual((ends[0], len(warnings)), (2, 2))  # lengths of the file are scaled, as the points are

    def test_a_wake_that_crosses_itself_or_turns_back_is_refused(self):
        for points, message in (("1 0\n5 0\n8 2\n6 3\n5.5 -1\n", "line 4: the wake crosses or touches itself"),
                                ("1 0\n5 0\n3 0\n", "line 2: the line turns back on itself")):
            with self.assertRaisesRegex(Failure, message):
                with_wake(WING, points)


if __name__ == "__main__":
    unittest.main()
