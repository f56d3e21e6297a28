import cmath
import math
import unittest

from command_frame import Failure
from outline import corners
from outline.loops import Loop
from outline.point_files import PointFile

FILE = PointFile("points", "")


def loop(*points):
    return Loop(list(points), list(range(1, len(points) + 1)))


class CornersTest(unittest.TestCase):
    def test_an_angle_above_the_limit_is_a_corner_and_one_equal_to_it_is_none(self):
        square = loop(0, 1, 2, 2 + 2j, 2j)
        corners.mark_corners(square, 30)
        self.assertEqual(square.corners, {0, 2, 3, 4})
        circle = loop(*[cmath.rect(1, 2 * math.pi * k / 12) for k in range(12)])
        corners.mark_corners(circle, 30)
        self.assertEqual(circle.corners, set())
        corners.mark_corners(circle, 29.9)
        self.assertEqual(circle.corners, set(range(12)))

    def test_right_and_left_turns_count_alike(self):
        self.assertAlmostEqual(corners.turning_angle(1, 1j), 90)
        self.assertAlmostEqual(corners.turning_angle(1, -1j), 90)

    def test_a_turn_that_stands_out_is_a_corner_however_small(self):
        bent = [complex(k) for k in range(10)] + [9 + k * cmath.rect(1, math.radians(8)) for k in range(1, 10)]
        shape = loop(*bent, 20 + 20j, -10 + 20j)
        corners.mark_sharp_corners(shape, 0)
        self.assertEqual(shape.corners, {0, 9, 18, 19, 20})
        # Points rounded to whole numbers turn by so much anyway.
        shape = loop(*bent, 20 + 20j, -10 + 20j)
        corners.mark_sharp_corners(shape, 0.5)
        self.assertEqual(shape.corners, {0, 18, 19, 20})

    def test_a_nose_stands_out_unless_it_is_round(self):
        def angles(height, nose):
            xs = [(1 - k / 20) for k in range(21)]
            side = [complex(x, height(x)) for x in xs]
            turns = corners.turns(side + [z.conjugate() for z in side[-2:0:-1]])
            return corners.stands_out(turns, [0.0] * len(turns), nose)

        self.assertTrue(angles(lambda x: 0.1 * min(x, 1 - x), 20))
        self.assertTrue(angles(lambda x: 0.2 * x * (1 - x), 20))
        for thickness in (0.2, 0.4, 1.0):  # few points around the nose of a parabola
            self.assertFalse(angles(lambda x, t=thickness: t * (math.sqrt(x) - x), 20))

    def test_rounded_points_of_a_coarse_arc_are_no_corners(self):
        pile = loop(*[complex(round(0.6 * math.cos(k * math.pi / 6), 2), round(0.6 * math.sin(k * math.pi / 6), 2))
                      for k in range(12)])
        corners.mark_sharp_corners(pile, 0.005)
        self.assertEqual(pile.corners, set())
        square = loop(0, 2, 2 + 2j, 2j)
        corners.mark_sharp_corners(square, 0.5)
        self.assertEqual(square.corners, {0, 1, 2, 3})


class AerofoilTest(unittest.TestCase):
    SHARP = 1, 0.5 + 0.1j, 0, 0.5 - 0.1j

    def test_a_sharp_one_has_a_corner_at_the_trailing_edge_and_a_joint_at_the_nose(self):
        wing = loop(*self.SHARP)
        self.assertEqual(corners.mark_aerofoil(FILE, wing, None, None, ""), (0, 1))
        self.assertEqual(wing.names, ["upper", "upper", "lower", "lower"])
        self.assertEqual((wing.corners, wing.joints), ({0}, {2}))

    def test_a_blunt_one_has_an_edge_between_two_corners(self):
        wing = loop(1 + 0.02j, 0.5 + 0.1j, 0, 0.5 - 0.1j, 1 - 0.02j)
        self.assertEqual(corners.mark_aerofoil(FILE, wing, 4, None, "main_"), (0, 1))
        self.assertEqual(wing.names, ["main_upper", "main_upper", "main_lower", "main_lower", "main_trailing_edge"])
        self.assertEqual(wing.corners, {0, 4})

    def test_upper_is_the_higher_side_in_either_direction_and_at_any_angle(self):
        turned = loop(*[z * cmath.rect(1, -2) for z in self.SHARP[:1] + self.SHARP[:0:-1]])
        corners.mark_aerofoil(FILE, turned, None, None, "")
        self.assertEqual(turned.names, ["lower", "lower", "upper", "upper"])

    def test_the_given_nose_counts(self):
        wing = loop(*self.SHARP)
        self.assertEqual(corners.mark_aerofoil(FILE, wing, None, 1, "")[0], 0.5 + 0.1j)
        with self.assertRaisesRegex(Failure, "line 1: the nose is the first or the last point"):
            corners.mark_aerofoil(FILE, loop(*self.SHARP), None, 0, "")
