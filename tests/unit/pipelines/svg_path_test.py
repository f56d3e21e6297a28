import math
import unittest

from drawing import svg_path
from drawing.curves import Segment


class SvgPathTest(unittest.TestCase):
    def ends(self, data):
        return [(curve.start, curve.end) for curve in svg_path.path_curves(data)]

    def test_lines_absolute_and_relative(self):
        square = [(1 + 1j, 3 + 1j), (3 + 1j, 3 + 2j), (3 + 2j, 1 + 2j), (1 + 2j, 1 + 1j)]
        for data in ("M1 1L3 1L3 2L1 2Z", "m1,1 2,0 0,1 -2,0z", "M1 1H3V2H1V1", "M1 1h2v1h-2v-1z", "M 1 1 3 1 3 2 1 2 z",
                     "M1 1 H 1e0 3 v1-0h-2.0z"):
            self.assertEqual(self.ends(data), square, data)

    def test_sub_paths_begin_anew(self):
        self.assertEqual(self.ends("M0 0 1 0 1 1z m5 0 1 0"), [(0, 1), (1, 1 + 1j), (1 + 1j, 0), (5, 6)])

    def test_bezier_curves_and_mirrored_handles(self):
        one, other = svg_path.path_curves("M0 0C0 1 1 2 2 2S4 3 4 4")
        self.assertEqual(other.poles, (2 + 2j, 3 + 2j, 4 + 3j, 4 + 4j))
        self.assertEqual(one.poles, (0, 1j, 1 + 2j, 2 + 2j))
        one, other = svg_path.path_curves("m0 0q1 1 2 0t2 0")
        self.assertEqual((one.poles, other.poles), ((0, 1 + 1j, 2), (2, 3 - 1j, 4)))
        self.assertEqual(svg_path.path_curves("M0 0S1 1 2 0")[0].poles, (0, 0, 1 + 1j, 2))

    def test_arcs(self):
        for flags, middle in (("0 1", 1 - 1j), ("0 0", 1 + 1j)):
            arc = svg_path.path_curves(f"M0 0A1 1 0 {flags} 2 0")[0]
            self.assertAlmostEqual(arc.at(sum(arc.range) / 2), middle)
            self.assertAlmostEqual(arc.start, 0)
            self.assertAlmostEqual(arc.end, 2)
        for flags, angle in (("01", math.pi / 2), ("00", math.pi / 2), ("11", 1.5 * math.pi), ("10", 1.5 * math.pi)):
            arc = svg_path.path_curves(f"M1 0a1 1 0 {flags}-1 1")[0]
            self.assertAlmostEqual(abs(arc.range[1] - arc.range[0]), angle)
            self.assertAlmostEqual(arc.end, 1j)

    def test_arcs_that_are_too_small_grow_and_flat_ones_are_lines(self):
        self.assertAlmostEqual(svg_path.path_curves("M0 0a1 1 0 0 1 4 0")[0].half_axes[1], 2)
        self.assertEqual(svg_path.path_curves("M0 0a0 1 0 0 1 4 0"), [Segment(0, 4)])
        turned = svg_path.path_curves("M0 0a2 1 90 0 1 2 0")[0].half_axes
        self.assertAlmostEqual(abs(turned[0].imag), 2)

    def test_mistakes(self):
        for data, message in (("L1 1", "it does not begin with M or m"), ("M1", "a number expected at its end"),
                              ("M0 0L1 1X", "a command expected before 'X'"), ("M0 0 a1 1 0 2 0 1 1", "a flag, 0 or 1, expected before '2 0 1 1'")):
            with self.assertRaisesRegex(svg_path.PathError, message):
                svg_path.path_curves(data)
        self.assertEqual(svg_path.path_curves(" none "), [])


if __name__ == "__main__":
    unittest.main()
