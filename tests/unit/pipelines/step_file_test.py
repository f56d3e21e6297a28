import re
import unittest

from outline import step_file
from outline.edges import Arc, EllipticArc, Line, Spline

TRIANGLE = [Line(0, 1, "floor"), Line(1, 1j, ""), Line(1j, 0, "")]


def written(*loops, name="", unit="m", size=1.0):
    return step_file.step_file("title", [(name, loops or [TRIANGLE])], unit, size)


class StepFileTest(unittest.TestCase):
    def test_reals_have_a_point_and_a_capital_exponent(self):
        self.assertEqual([step_file.real(x) for x in (1, -0.0, 0.1, 1e-30, 2.5e22)], ["1.0", "0.0", "0.1", "1.E-30", "2.5E+22"])

    def test_strings_are_ascii_with_doubled_quotes_and_coded_letters(self):
        self.assertEqual(step_file.text("a'b\\"), "'a''b\\\\'")
        self.assertEqual(step_file.text("ü"), "'\\X2\\00FC\\X0\\'")
        self.assertEqual(step_file.text("\U0001f600"), "'\\X4\\0001F600\\X0\\'")

    def test_statements_refer_to_earlier_ones_only(self):
        numbers = []
        for line in written().splitlines():
            if match := re.match(r"#(\d+) = (.*);$", line):
                numbers.append(int(match[1]))
                self.assertTrue(all(int(k) < numbers[-1] for k in re.findall(r"#(\d+)", match[2])), line)
        self.assertEqual(numbers, list(range(1, len(numbers) + 1)))

    def test_edges_that_meet_share_a_vertex(self):
        self.assertEqual(written().count("VERTEX_POINT("), 3)
        self.assertEqual(written().count("EDGE_CURVE('floor'"), 1)

    def test_the_first_loop_is_the_outer_bound(self):
        hole = [Arc(0.3 + 0.3j, 0.1, 0.4 + 0.3j, 0.4 + 0.3j, "hole")]
        found = written(TRIANGLE, hole, name="plate")
        self.assertEqual((found.count("FACE_OUTER_BOUND("), found.count("FACE_BOUND("), found.count("CIRCLE(")), (1, 1, 1))
        self.assertIn("ADVANCED_FACE('plate',", found)

    def test_a_spline_has_clamped_ends_and_simple_inner_knots(self):
        found = written([Spline([0, 1, 1 + 1j, 1j, 0], [0.0, 1.0, 2.0], "")])
        self.assertIn(".UNSPECIFIED.,.T.,.F.,(4,1,4),(0.0,1.0,2.0),.UNSPECIFIED.)", found)

    def test_embedded_edges_are_curves_beside_the_face(self):
        inner = [Spline([0.1, 0.2, 0.3, 0.4], [0.0, 1.0], "wake"), Line(0.4, 0.5, "wake")]
        found = step_file.step_file("title", [("", [TRIANGLE])], "m", 1.0, inner)
        self.assertEqual((found.count("B_SPLINE_CURVE_WITH_KNOTS('wake'"), found.count("TRIMMED_CURVE('wake'")), (1, 1))
        self.assertEqual((found.count("GEOMETRIC_CURVE_SET("), found.count("SHAPE_DEFINITION_REPRESENTATION(")), (1, 2))
        self.assertNotIn("GEOMETRIC_CURVE_SET(", written())

    def test_two_faces_share_an_edge_in_both_directions(self):
        common = Line(0, 1j, "middle")
        left = [step_file.Reversed(common)]
        found = step_file.step_file("title", [("left", [left]), ("right", [[common]])], "mm", 1.0)
        self.assertEqual((found.count("EDGE_CURVE('middle'"), found.count("ADVANCED_FACE(")), (1, 2))
        number = re.search(r"#(\d+) = EDGE_CURVE\('middle'", found)[1]
        self.assertEqual(re.findall(rf"ORIENTED_EDGE\('',\*,\*,#{number},\.([TF])\.\)", found), ["F", "T"])

    def test_ellipses_and_rational_splines(self):
        found = written([EllipticArc(1j, 2j, 1.0, 3j, -1j, "oval")])
        self.assertIn("DIRECTION('',(0.0,1.0,0.))", found)
        self.assertRegex(found, r"ELLIPSE\('',#\d+,2\.0,1\.0\)")
        arc = Spline([1, 1 + 1j, 1j], [0.0, 1.0], "", 2, (), (1.0, 0.5**0.5, 1.0))
        self.assertRegex(written([arc]), r"B_SPLINE_CURVE\(2,.*\(3,3\),\(0\.0,1\.0\).*RATIONAL_B_SPLINE_CURVE\(\(1\.0,0\.707")
        double = Spline([0, 1, 2, 3, 4, 5], [0.0, 1.0, 2.0], "", 3, (4, 2, 4))
        self.assertIn("(4,2,4),(0.0,1.0,2.0)", written([double]))

    def test_embedded_arcs_end_where_they_do(self):
        inner = [Arc(0, 1.0, 1, 1j, "quarter"), Arc(0, 1.0, 1, 1, "whole")]
        found = step_file.step_file("title", [("", [TRIANGLE])], "m", 1.0, inner)
        self.assertEqual((found.count("TRIMMED_CURVE('quarter'"), found.count("TRIMMED_CURVE('whole'")), (1, 0))

    def test_units_and_accuracy(self):
        self.assertIn("SI_UNIT(.MILLI.,.METRE.)", written(unit="mm"))
        self.assertIn("CONVERSION_BASED_UNIT('INCH',", written(unit="in"))
        self.assertIn("LENGTH_MEASURE(1.E-07)", written(size=1.0))
        self.assertIn("LENGTH_MEASURE(1.E-06)", written(size=99.0))

    def test_states_how_it_was_made(self):
        origin = step_file.made_by("points2step", "dat", b"0 0", {"points": "x", "--wake": "it's", "--straight": None,
                                                                  "--output": "y", "--quiet": None})
        self.assertIn('"options": {"straight": true, "wake": "it\'s"}', origin)
        found = step_file.step_file("title", [("", [TRIANGLE])], "m", 1.0, origin=origin)
        header = found[:found.index("FILE_NAME")]
        self.assertLess(max(map(len, header.splitlines())), 256)
        self.assertEqual("".join(header.split("',\n'")[1:]).split("'),'2;1'")[0].replace("''", "'"), origin)

