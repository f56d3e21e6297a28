import unittest

from command_frame import Failure
from outline import forms
from outline.point_files import PointFile
from outline_samples import selig, side, text


def form(content, requested="auto"):
    return forms.read_form(PointFile("points", content), requested)


class DetectedTest(unittest.TestCase):
    def test_a_heading_makes_no_aerofoil_and_none_is_needed(self):
        for heading in ("", "house\n", "x,y\n"):
            self.assertEqual(form(heading + "0 0\n4 0\n4 3\n2 4.5\n0 3\n").kind, "points")
            found = form(text(selig(), heading))
            self.assertEqual((found.kind, found.notes[0]),
                             ("selig", "an aerofoil from the trailing edge around the nose and back, 40 points"))

    def test_halves_from_the_nose_with_and_without_their_numbers(self):
        upper = side(20)[::-1]
        lower = [z.conjugate() for z in upper]
        whole = form(text(selig())).loops[0].points
        for content in (text(upper, "wing\n21. 21.\n\n") + "\n" + text(lower), text(upper) + "\n" + text(lower),
                        text(upper) + text(lower), text(upper + lower, "21 21\n")):
            found = form(content)
            self.assertEqual((found.kind, found.loops[0].points, found.aerofoils[0].nose), ("lednicer", whole, 20))

    def test_blank_lines_within_an_aerofoil_and_between_two(self):
        points = selig()
        self.assertEqual(form(text(points[:21]) + "\n" + text(points[21:])).kind, "selig")
        two = text(points) + "\n" + text([0.3 * z + 1.1 - 0.1j for z in points])
        self.assertEqual(len(form(two).aerofoils), 2)
        self.assertEqual(form(two + "\n3 0\n4 0\n4 1\n").kind, "points")

    def test_what_was_read_in_a_special_way_is_noted(self):
        wing = selig()[:-1]
        self.assertIn("the points from line 1 on start at the nose", form(text(wing[20:] + wing[:20])).notes[1])
        self.assertIn("2 repeated points are left out, line 4 the first", form(text(wing[:3] + wing[2:9] + wing[8:])).notes)
        crossing = [1 - 1e-4j] + wing[1:] + [1 + 1e-4j]
        self.assertIn("the sides cross by 0.0002 at the trailing edge", form(text(crossing, digits=5)).notes[-1])

    def test_loops_that_cross_are_refused(self):
        with self.assertRaisesRegex(Failure, "line 4: the loop crosses or touches itself"):
            form("0 0\n2 0\n0 2\n2 2\n")


class RequestedTest(unittest.TestCase):
    WING = "wing\n3 2\n0 0\n0.5 0.1\n1 0\n0 0\n0.5 -0.1\n"

    def test_an_aerofoil_of_few_points(self):
        found = form(self.WING, "lednicer")
        self.assertEqual((found.loops[0].points, found.loops[0].lines), ([1, 0.5 + 0.1j, 0, 0.5 - 0.1j], [5, 4, 3, 7]))
        self.assertEqual(found.aerofoils[0].base, 3)  # the last point is not the first one
        self.assertIsNone(form("1 0\n0.5 0.1\n0 0\n0.5 -0.1\n1 0\n", "selig").aerofoils[0].base)

    def test_the_number_of_points_must_be_the_announced_one(self):
        with self.assertRaisesRegex(Failure, "line 2: expected 2 \\+ 2 points, found 3"):
            form("wing\n2 2\n0 0\n1 0\n0 0\n", "lednicer")
        with self.assertRaisesRegex(Failure, "line 2: expected the numbers of points"):
            form("wing\n0 0.5\n1 0\n", "lednicer")

    def test_points_are_no_aerofoil_if_loops_are_requested(self):
        self.assertEqual(form(text(selig(), "wing\n"), "points").kind, "points")


if __name__ == "__main__":
    unittest.main()
