import unittest

from drawing import curves, step_edges
from drawing.regions import Side
from drawing_samples import QUARTER, edges_of
from outline.edges import Arc, EllipticArc, Line
from outline.step_file import Reversed


class StepEdgesTest(unittest.TestCase):
    def made(self, curve):
        return step_edges.step_edge(edges_of({"name": [curve]})[1][0])

    def test_kinds(self):
        self.assertEqual(self.made(curves.Segment(0, 1)), (Line(0, 1, "name"), True))
        arc, is_along = self.made(curves.bulged(1 + 0j, -1 + 0j, -1.0))
        self.assertIsInstance(arc, Arc)
        self.assertFalse(is_along)
        self.assertAlmostEqual(arc.start, -1)
        oval, is_along = self.made(curves.ellipse(0, 1, 3j))
        self.assertIsInstance(oval, EllipticArc)
        self.assertTrue(is_along)
        self.assertAlmostEqual(abs(oval.major.imag), 3)
        spline, _ = self.made(QUARTER)
        self.assertEqual((spline.degree, spline.knots, spline.multiplicities, spline.weights), (2, [0, 1], (3, 3), QUARTER.weights))

    def test_both_sides_have_one_edge(self):
        edge, made = edges_of({"a": [curves.Segment(0, 1)]})[1][0], step_edges.StepEdges()
        one, other = made.side(Side(edge, True)), made.side(Side(edge, False))
        self.assertIsInstance(other, Reversed)
        self.assertIs(other.edge, one)


if __name__ == "__main__":
    unittest.main()
