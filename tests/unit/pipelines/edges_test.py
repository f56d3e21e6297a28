import cmath
import unittest

from outline import edges
from outline.edges import Arc, Line, Spline
from outline.loops import Loop


def loop(points, corners=(), joints=()):
    made = Loop(list(points), list(range(len(points))))
    made.names = [f"from {k}" for k in range(len(points))]
    made.corners, made.joints = set(corners), set(joints)
    return made


def ends(found):
    return [(edge.start, edge.end) for edge in found]


class LoopEdgesTest(unittest.TestCase):
    CIRCLE = [cmath.rect(1, k * cmath.pi / 4) for k in range(8)]

    def test_straight_edges_join_all_points(self):
        self.assertEqual(edges.straight_edges(loop([0, 1, 1j])),
                         [Line(0, 1, "from 0"), Line(1, 1j, "from 1"), Line(1j, 0, "from 2")])

    def test_without_corners_the_loop_is_one_closed_spline(self):
        (edge,) = edges.loop_edges(loop(self.CIRCLE))
        self.assertIsInstance(edge, Spline)
        self.assertEqual((edge.start, edge.end, len(edge.knots)), (1, 1, 9))

    def test_from_corner_to_corner_two_points_are_a_line_and_more_a_spline(self):
        found = edges.loop_edges(loop(self.CIRCLE, corners=(2, 3)))
        self.assertEqual(ends(found), [(self.CIRCLE[2], self.CIRCLE[3]), (self.CIRCLE[3], self.CIRCLE[2])])
        self.assertEqual([type(edge) for edge in found], [Line, Spline])
        self.assertEqual([edge.name for edge in found], ["from 2", "from 3"])

    def test_a_joint_ends_an_edge_but_not_the_curve(self):
        first, second = edges.loop_edges(loop(self.CIRCLE, corners=(0,), joints=(3,)))
        self.assertEqual((first.end, second.start), (self.CIRCLE[3], self.CIRCLE[3]))
        self.assertEqual((first.name, second.name), ("from 0", "from 3"))
        into = (first.poles[-1] - first.poles[-2]) / (first.knots[-1] - first.knots[-2])
        out = (second.poles[1] - second.poles[0]) / (second.knots[1] - second.knots[0])
        self.assertAlmostEqual(into, out, 12)


class FarFieldTest(unittest.TestCase):
    def test_every_kind_is_closed_and_called_farfield(self):
        for kind in edges.FAR_FIELDS:
            found = edges.far_field_edges(kind, 2, 0.5, 1)
            for a, b in zip(found, found[1:] + found[:1]):
                self.assertEqual(a.end, b.start)
                self.assertEqual(a.name, "farfield")

    def test_places(self):
        self.assertEqual(edges.far_field_edges("circle", 2, 0.5, 1), [Arc(0.5, 2, 2.5, 2.5, "farfield")])
        self.assertEqual(ends(edges.far_field_edges("box", 2, 1, 5))[0], (-1 - 2j, 3 - 2j))
        *lines, arc = edges.far_field_edges("cgrid", 2, 0.5, 1)
        self.assertEqual(ends(lines), [(1 - 2j, 3 - 2j), (3 - 2j, 3 + 2j), (3 + 2j, 1 + 2j)])
        self.assertEqual((arc.centre, arc.radius, arc.start, arc.end), (1, 2, 1 + 2j, 1 - 2j))


class NearEdgesTest(unittest.TestCase):
    # A wall from 0 to 8, then an arc of a circle that touches it, and back.
    ARC = [8 + 2j + 2 * cmath.exp(1j * (k * cmath.pi / 16 - cmath.pi / 2)) for k in range(9)]

    def test_a_curve_turns_smoothly_into_a_wall(self):
        made = loop([0, 4, *self.ARC, 10 + 9j, 9j], corners=(0, 10, 11, 12))
        made.walls = {0: 0, 1: 0}
        wall, curve, *_ = edges.loop_edges(made)
        self.assertEqual(wall, Line(0, 8, "from 0"))
        self.assertAlmostEqual((curve.poles[1] - curve.poles[0]).imag, 0, 12)

    def test_without_corners_both_ends_of_a_wall_are_smooth(self):
        half = [complex(8 + 2 * cmath.sin(a).real, 2 - 2 * cmath.cos(a).real) for a in (k * cmath.pi / 8 for k in range(9))]
        made = loop([0, *half, *[8 + 2j - (z - 8 - 2j) - 8 for z in half][:-1]])
        made.walls = {0: 0}
        wall, curve = edges.loop_edges(made)
        self.assertEqual(ends([wall, curve]), [(0, 8), (8, 0)])
        for step in (curve.poles[1] - curve.poles[0], curve.poles[-1] - curve.poles[-2]):
            self.assertAlmostEqual(step.imag, 0, 12)

    def test_points_move_within_the_tolerance_but_not_those_of_small_loops(self):
        noisy = [cmath.rect(5 + 0.1 * (-1) ** k, k * cmath.pi / 20) for k in range(40)]
        (edge,) = edges.loop_edges(loop(noisy), edges.Nearness(smoothing=0.2))
        self.assertTrue(all(4.9 < abs(z) < 5.2 for z in edge.poles))
        (edge,) = edges.loop_edges(loop(noisy), edges.Nearness(smoothing=9))
        self.assertFalse(all(4.9 < abs(z) < 5.2 for z in edge.poles))
