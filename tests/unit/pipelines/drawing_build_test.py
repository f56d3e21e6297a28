import math
import unittest

import command_frame as frame
from drawing import curves
from drawing.curves import Segment
from drawing.drawing_build import NameList, Settings, build_faces
from drawing_samples import sketch_of, square


class DrawingBuildTest(unittest.TestCase):
    def refusal(self, layers, settings=Settings()):
        with self.assertRaises(frame.Failure) as caught:
            build_faces(sketch_of(layers), settings)
        return str(caught.exception)

    def test_lists_of_names(self):
        names = NameList("--embed", "a,b*")
        self.assertEqual([names.matches(name) for name in ("a", "bc", "c", "A")], [True, True, False, False])
        names.require_matches(sketch_of({}))
        self.assertFalse(NameList("--embed", "!a,b").matches("b"))
        with self.assertRaisesRegex(frame.Failure, "--embed: no curve is called 'b'; there are a, c"):
            other = NameList("--embed", "a,b")
            other.matches("a"), other.matches("c")
            other.require_matches(sketch_of({}))

    def test_a_face_with_a_hole(self):
        text, summary = build_faces(sketch_of({"wall": square(0, 10), "hole": [curves.circle(5 + 5j, 2)]}), Settings())
        self.assertEqual(summary, "sketch: 5 curves, diagonal 14.1421 mm, 1 face, 1 hole, 5 edges")
        self.assertIn("ADVANCED_FACE('',", text)
        self.assertEqual((text.count("EDGE_CURVE('wall'"), text.count("EDGE_CURVE('hole'")), (4, 1))
        self.assertIn("'drawing2step'", text)

    def test_regions_share_their_curve_and_have_names(self):
        layers = {"wall": square(0, 10), "hole": [curves.circle(5 + 5j, 2)]}
        text, _ = build_faces(sketch_of(layers), Settings(has_all_regions=True))
        self.assertEqual((text.count("ADVANCED_FACE('wall'"), text.count("ADVANCED_FACE('hole'")), (1, 1))
        self.assertEqual((text.count("EDGE_CURVE('hole'"), text.count(",.F.)")), (1, 1))

    def test_neighbours_that_both_have_their_side_keep_their_names(self):
        text, _ = build_faces(sketch_of({"steel": square(0, 2), "copper": square(2, 2)}), Settings())
        self.assertEqual((text.count("ADVANCED_FACE('steel'"), text.count("ADVANCED_FACE('copper'")), (1, 1))
        self.assertEqual((text.count("EDGE_CURVE('steel'"), text.count("EDGE_CURVE('copper'")), (4, 3))

    def test_embedded_curves(self):
        layers = {"wall": square(0, 10), "cut": [Segment(2 + 2j, 4 + 4j), curves.circle(7 + 7j, 1, 0, math.pi)]}
        text, _ = build_faces(sketch_of(layers), Settings(embed="cut"))
        self.assertEqual(text.count("TRIMMED_CURVE('cut'"), 2)
        self.assertIn("no curve bounds a face", self.refusal(layers, Settings(embed="*")))

    def test_what_cannot_be_a_boundary(self):
        self.assertIn("there is no curve", self.refusal({}))
        self.assertIn("no curve is longer than the tolerance, 3:", self.refusal({"a": square(0, 1)}, Settings(tolerance=3)))
        self.assertIn("a 4 is flat", self.refusal({"a": [*square(0, 10), curves.ellipse(1, 3, 0j)]}))
        self.assertIn("a 0 has a number that is not finite, or above 1e+100", self.refusal({"a": [Segment(0, complex(math.inf, 0))]}))

    def test_the_tolerance_is_a_share_of_the_drawing(self):
        layers = {"a": [*square(0, 10)[:3], Segment(10j, 1e-4 + 0j)]}
        build_faces(sketch_of(layers), Settings())
        self.assertIn("a gap of 0.0001 mm", self.refusal(layers, Settings(tolerance=1e-5)))


if __name__ == "__main__":
    unittest.main()
