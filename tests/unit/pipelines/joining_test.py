import math
import unittest

import command_frame as frame
from drawing import curves, joining
from drawing.curves import Segment
from drawing_samples import QUARTER, edges_of, polygon, sketch_of, square


class JoiningTest(unittest.TestCase):
    def refusal(self, layers, check):
        sketch, edges = edges_of(layers)
        with self.assertRaises(frame.Failure) as caught:
            check(sketch, edges)
        return str(caught.exception)

    def test_near_ends_are_one_vertex_where_an_arc_ends(self):
        layers = {"arc": [curves.circle(0, 1, 0, 3)], "line": [Segment(1 + 1e-7j, 2), Segment(2 + 1e-8j, 3)]}
        sketch, (arc, line, other) = edges_of(layers)
        self.assertEqual(sketch.notes, ["ends up to 1e-07 mm apart are joined, most at (1, 0)"])
        self.assertEqual((arc.start, line.start, line.curve.start), (1, 1, 1))
        self.assertEqual((line.end, other.start), (2, 2))
        self.assertEqual(arc.end, arc.curve.end)

    def test_ends_farther_apart_stay(self):
        self.assertEqual(len({edge.start for edge in edges_of({"a": square(0, 1)})[1]}), 4)
        _, (one, other) = edges_of({"a": [Segment(0, 1), Segment(1 + 2e-6j, 2)]})
        self.assertNotEqual(one.end, other.start)

    def test_short_curves_are_left_out_with_a_warning(self):
        sketch, edges = edges_of({"a": [*square(0, 1), Segment(0.5j, 0.5j + 1e-7), curves.circle(5, 1e-8)]})
        self.assertEqual(len(edges), 4)
        self.assertEqual(sketch.warnings[0][0], "W-DRW-001")
        self.assertTrue(sketch.warnings[0][1].startswith("left out, as no longer than 1e-06 mm: a 4 at (0, 0.5), a 5"))

    def test_a_vertex_on_a_curve_divides_it(self):
        _, edges = edges_of({"frame": square(0, 2), "bar": [Segment(1, 1 + 2j)]})
        self.assertEqual([edge.name for edge in edges], ["frame"] * 6 + ["bar"])
        _, edges = edges_of({"round": [curves.circle(0, 1)], "bar": [Segment(1j, -1j)]})
        self.assertEqual([(edge.start, edge.end) for edge in edges[:2]], [(1j, -1j), (-1j, 1j)])
        self.assertEqual(len(edges), 3)
        _, edges = edges_of({"arc": [QUARTER], "bar": [Segment(0, 0.6 + 0.8j)]})
        self.assertEqual([edge.curve.degree for edge in edges[:2]], [2, 2])
        self.assertAlmostEqual(abs(edges[0].middle), 1, 12)

    def test_curves_that_lie_upon_others_are_kept_once(self):
        layers = {"a": square(0, 2), "b": polygon(2, 3, 3 + 1j, 2 + 1j), "c": [Segment(0.5, 1.5)]}
        sketch, edges = edges_of(layers)
        kept = joining.kept_once(edges, 1e-6, sketch.warnings)
        self.assertEqual((len(edges), len(kept)), (12, 10))
        self.assertTrue(sketch.warnings[0][1].startswith("kept once, although drawn several times: b 3 on a 1 at (2, 0.5)"))
        arcs = {"a": [curves.circle(0, 1)], "b": [curves.bulged(1 + 0j, -1 + 0j, 1.0), curves.bulged(1 + 0j, -1 + 0j, -1.0)]}
        sketch, edges = edges_of(arcs)
        self.assertEqual([edge.name for edge in joining.kept_once(edges, 1e-6, [])], ["a", "a"])

    def test_gaps_are_named(self):
        points = [0, 10, 10 + 10j, 10j]
        gap = {"wall": [*polygon(*points)[:3], Segment(10j, 0.01j)]}
        message = self.refusal(gap, lambda sketch, edges: joining.refuse_gaps(sketch, edges, 14.0))
        self.assertEqual(message, "sketch.dxf: a gap of 0.01 mm at (0, 0): wall 0 ends 0.01 mm from wall 3: close it in the "
                         "drawing, join what is as near by --drawing-tolerance 0.011, leave its layer out "
                         "(--drawing-layers) or embed it (--embed)")
        far = {"a": square(0, 4), "b": [Segment(1 + 1j, 2 + 1j)]}
        message = self.refusal(far, lambda sketch, edges: joining.refuse_gaps(sketch, edges, 5.7))
        self.assertIn("a gap of 1 mm at (1, 1): b 0 ends 1 mm from a ", message)
        self.assertNotIn("tolerance", message)
        self.assertIn("no other curve", self.refusal({"a": [Segment(0, 1)]}, lambda s, e: joining.refuse_gaps(s, e, 1.0)))

    def test_crossings_are_named(self):
        layers = {"a": square(0, 2), "b": [curves.circle(2 + 1j, 0.5)]}
        message = self.refusal(layers, lambda sketch, edges: joining.refuse_crossings(sketch, edges, 1e-6))
        self.assertRegex(message, r"a 1 crosses b 0 at \(2, (0|1)\.5\): trim them")
        loop = curves.bezier([0, 3 + 2j, -2 + 2j, 1])
        message = self.refusal({"a": [loop, Segment(1, 0)]}, lambda s, e: joining.refuse_crossings(s, e, 1e-6))
        self.assertIn("a 0 crosses itself at (0.5, ", message)

    def test_curves_that_only_touch_do_not_cross(self):
        for layers in ({"a": square(0, 2), "b": [Segment(1, 1 + 2j)]}, {"a": [curves.circle(0, 2), curves.circle(0, 1)]},
                       {"a": [Segment(-1, 0), curves.circle(1j, 1, -1.5707963267948966, 0), Segment(1 + 1j, 1 + 2j)]}):
            joining.refuse_crossings(*edges_of(layers), 1e-6)
        # Circles that touch at their common vertex, but for rounding.
        around = -math.pi / 2, 1.5 * math.pi
        for shift in (-5e-7j, 5e-7j):
            layers = {"a": [curves.circle(1j, 1, *around), curves.circle(2j + shift, 2, *around)]}
            joining.refuse_crossings(*edges_of(layers), 1e-6)

    def test_the_diagonal(self):
        self.assertEqual(joining.diagonal(sketch_of({"a": polygon(0, 3, 3 + 4j)}).entities), 5)

    def test_tolerances_are_rounded_up(self):
        self.assertEqual([f"{joining.rounded_up(x):.2g}" for x in (0.0199, 0.02, 3.14)], ["0.021", "0.021", "3.3"])


if __name__ == "__main__":
    unittest.main()
