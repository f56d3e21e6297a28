import unittest

from command_frame import Failure
from outline.build import Settings, build_outline
from outline.edges import Arc, Line, Spline
from outline.point_files import PointFile

PLATE = "0 0\n4 0\n4 2\n0 2\n\n1 0.5\n2 0.5\n2 1.5\n"
WING = "wing\n1 0\n0.5 0.1\n0 0\n0.5 -0.1\n1 0\n"
BLUNT = "wing\n1 0.01\n0.5 0.1\n0 0\n0.5 -0.1\n1 -0.01\n"


def built(text, **settings):
    return build_outline(PointFile("points", text), Settings(**settings))


class BuildTest(unittest.TestCase):
    def test_a_polygon_has_lines_between_its_corners(self):
        plate = built(PLATE, name="wall,pipe")
        self.assertEqual([[edge.name for edge in loop] for loop in plate.edges], [["wall"] * 4, ["pipe"] * 3])
        self.assertTrue(all(isinstance(edge, Line) for loop in plate.edges for edge in loop))
        self.assertEqual((plate.kind, plate.num_points), ("points", 7))
        self.assertAlmostEqual(plate.chord, 20**0.5)

    def test_smooth_loops_have_splines_unless_the_corner_angle_is_small(self):
        octagon = "3 0\n2 2\n0 3\n-2 2\n-3 0\n-2 -2\n0 -3\n2 -2\n"
        self.assertEqual([type(edge) for edge in built(octagon, corner_angle=60).edges[0]], [Spline])
        self.assertEqual(len(built(octagon, corner_angle=10).edges[0]), 8)
        self.assertEqual([type(edge) for edge in built(octagon, is_straight=True).edges[0]], [Line] * 8)

    def test_an_aerofoil_has_two_sides_and_a_blunt_one_a_trailing_edge(self):
        self.assertEqual([edge.name for edge in built(WING, format="selig").edges[0]], ["upper", "lower"])
        self.assertEqual({edge.name for edge in built(BLUNT, name="flap", format="selig").edges[0]},
                         {"flap_upper", "flap_lower", "flap_trailing_edge"})

    def test_the_chord_is_scaled_and_is_the_unit_of_the_far_field(self):
        wing = built(WING, format="selig", chord=0.5, far_field=("circle", 4.0))
        self.assertEqual((wing.chord, wing.size, len(wing.edges)), (0.5, 2.0, 2))
        self.assertEqual(wing.edges[0], [Arc(0.25, 2.0, 2.25, 2.25, "farfield")])

    def test_each_loop_needs_a_name_and_the_points_a_size(self):
        with self.assertRaisesRegex(Failure, "--name a: 1 names for 2 loops"):
            built(PLATE, name="a")
        with self.assertRaisesRegex(Failure, "line 1: the largest distance of two points is 0"):
            built("1 1\n1 1\n1 1\n")

    def test_the_format_may_be_given(self):
        self.assertEqual(built(WING.replace("wing\n", ""), format="selig").kind, "selig")
        self.assertEqual([edge.name for edge in built(WING, format="points").edges[0]], ["", ""])

    def test_the_notes_tell_what_was_read_and_how_far_the_curves_are_away(self):
        notes = built("x,y\n0 0\n4 0\n4 0\n4 2\n2 2.4\n0 2\n").notes
        self.assertEqual(notes[0], "1 closed loop through 5 points")
        self.assertIn("line 1 is a heading: 'x,y'", notes)
        self.assertIn("1 repeated point is left out, line 4", notes)
        self.assertIn("the curves are up to 0.0981 away from the polygon (4.8 % of the spacing there)", notes[-1])

    def test_a_tolerance_smooths_noise_and_a_simplified_outline_has_fewer_points(self):
        coast = [f"{k / 10} {(5 + 0.02 * (-1) ** k)}" for k in range(100, -1, -1)]
        text = "0 0\n10 0\n" + "\n".join(coast) + "\n"
        self.assertGreater(len(built(text).edges[0]), 50)
        smooth = built(text, tolerance=0.05)
        self.assertEqual([type(edge) for edge in smooth.edges[0]], [Line, Line, Spline, Line])
        self.assertTrue(all(abs(z.imag - 5) < 0.05 for z in smooth.edges[0][2].poles))
        self.assertEqual(built(text, simplify=0.05, is_straight=True).num_points, 4)


if __name__ == "__main__":
    unittest.main()
