import pathlib
import tempfile
import unittest

from command_frame import Failure
from outline import wake
from outline.build import Settings, build_outline
from outline.edges import Line, Spline
from outline.point_files import PointFile

WING = "wing\n1 0\n0.5 0.1\n0 0\n0.5 -0.1\n1 0\n"
CAMBERED = "wing\n1 0\n0.5 0.3\n0 0\n0.5 0.1\n1 0\n"
BLUNT = "wing\n1 0.01\n0.5 0.1\n0 0\n0.5 -0.1\n1 -0.01\n"


def wake_of(text, far_field, **settings):
    settings = {"wake": "auto", "format": "selig" if text.startswith("wing") else "auto", **settings}
    return build_outline(PointFile("points", text), Settings(far_field=far_field, **settings)).embedded


class WakeTest(unittest.TestCase):
    def test_it_runs_straight_behind_a_symmetric_aerofoil(self):
        for text in (WING, BLUNT):
            (edge,) = wake_of(text, ("cgrid", 10.0))
            self.assertEqual((edge.name, edge.start, edge.end), ("wake", 1, 11))
            self.assertTrue(all(abs(z.imag) < 1e-15 for z in edge.poles))

    def test_it_follows_the_bisector_and_turns_into_the_stream(self):
        (edge,) = wake_of(CAMBERED, ("cgrid", 10.0))
        first, last = edge.poles[1] - edge.poles[0], edge.poles[3] - edge.poles[2]
        self.assertLess(first.imag, -0.1)
        self.assertAlmostEqual(last.imag, 0)
        # In the direction of the mean of both sides at the tail, which are the last segments of the polygon.
        upper, lower = (1 - (0.5 + 0.3j)), (1 - (0.5 + 0.1j))
        bisector = upper / abs(upper) + lower / abs(lower)
        self.assertAlmostEqual((first / bisector).imag, 0)

    def test_it_ends_on_the_far_field(self):
        self.assertAlmostEqual(wake_of(WING, ("box", 5.0))[0].end, 5.5)
        self.assertAlmostEqual(abs(wake_of(CAMBERED, ("circle", 5.0))[0].end - 0.5), 5)
        self.assertAlmostEqual(wake_of(WING, ("cgrid", 5.0), chord=2.0)[0].end, 12)

    def test_it_begins_at_the_rightmost_point_of_other_shapes(self):
        (edge,) = wake_of("3 1\n2 2\n1 1\n2 0\n", ("cgrid", 5.0))
        self.assertEqual(edge.start, 3 + 1j)

    def test_it_begins_in_the_middle_of_a_flat_back(self):
        def start(text, **settings):
            (edge,) = wake_of(text, ("cgrid", 5.0), **settings)
            return edge.start

        self.assertEqual(start("0 -1\n2 -1\n2 1\n0 1\n"), 2)
        self.assertEqual(start("0 1\n2 1\n2 0.7\n2 -1\n0 -1\n"), 2)  # clockwise, with a point on the back
        self.assertEqual(start("0 -1\n2 -1\n2.2 1\n0 1\n"), 2.1)  # not quite vertical
        self.assertEqual(start("0 -1\n2 -1\n3 1\n0 1\n"), 3 + 1j)  # far from it
        self.assertEqual(start("0 -2\n2 -1\n2 1\n0 2\n-3 0\n", corner_angle=20), 2)
        round_back = start("2 1\n1 2\n-1 2\n-2 1\n-2 -1\n-1 -2\n1 -2\n2 -1\n", corner_angle=90)
        self.assertAlmostEqual(round_back.imag, 0)
        self.assertTrue(2.1 < round_back.real < 2.3)
        self.assertEqual(start("2 1\n1 2\n-1 2\n-2 0\n-1 -2\n1 -2\n2 -1\n", corner_angle=90, is_straight=True), 2)

    def test_it_runs_through_given_points(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "wake.txt"
            path.write_text("1 0\n3 0.2\n6 0.1\n11 0\n")
            (edge,) = wake_of(WING, ("cgrid", 10.0), wake=str(path), chord=2.0)
            self.assertIsInstance(edge, Spline)
            self.assertEqual((edge.start, edge.end), (2, 22))
            path.write_text("1 0\n11 0\n")
            self.assertEqual(wake_of(WING, ("cgrid", 10.0), wake=str(path)), [Line(1, 11, "wake")])
            for text, message in (("1 0\n", "expected the points of one line"), ("1 0\n1 0\n2 0\n", "line 2: repeats"),
                                  ("1 0\n2 0\n\n3 0\n4 0\n", "expected the points of one line")):
                path.write_text(text)
                with self.assertRaisesRegex(Failure, message):
                    wake_of(WING, ("cgrid", 10.0), wake=str(path))

    def test_it_needs_a_far_field_and_a_tail_that_points_downstream(self):
        with self.assertRaisesRegex(Failure, "--wake needs --farfield"):
            wake_of(WING, None)
        turned = "wing\n0 1\n-0.1 0.5\n0 0\n0.1 0.5\n0 1\n"
        with self.assertRaisesRegex(Failure, "does not point in the direction of x"):
            wake_of(turned, ("cgrid", 10.0))
        self.assertEqual(wake.tail_direction([1 + 0j, 0.5 + 0.1j, 0.5 - 0.1j], False), 1)


if __name__ == "__main__":
    unittest.main()
