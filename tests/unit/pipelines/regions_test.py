import math
import unittest

from drawing import curves, regions
from drawing.curves import Segment
from drawing_samples import edges_of, square


def found(layers, has_all_regions=False):
    sketch, edges = edges_of(layers)
    faces, inner = regions.find_faces(sketch, edges, has_all_regions)
    return [(regions.name_of(face), round(face.outline.area + sum(hole.area for hole in face.holes), 3)) for face in faces], \
        inner, sketch


NESTED = {"plate": square(0, 10), "hole": [curves.circle(5 + 5j, 3)], "pin": [curves.circle(5 + 5j, 1)]}


class RegionsTest(unittest.TestCase):
    def test_holes_and_what_lies_in_them(self):
        faces, inner, _ = found(NESTED)
        self.assertEqual(faces, [("plate", round(100 - 9 * math.pi, 3)), ("pin", round(math.pi, 3))])
        self.assertEqual(inner, [])

    def test_all_loops_as_regions(self):
        faces, _, _ = found(NESTED, True)
        self.assertEqual(faces, [("plate", round(100 - 9 * math.pi, 3)), ("hole", round(8 * math.pi, 3)),
                                 ("pin", round(math.pi, 3))])

    def test_a_divided_face_is_two(self):
        self.assertEqual(found({"a": square(0, 2), "bar": [Segment(0.5, 0.5 + 2j)]})[0], [("", 1.0), ("", 3.0)])
        self.assertEqual(found({"a": [curves.circle(0, 2)], "b": [Segment(2j, -2j)]})[0],
                         [("", round(2 * math.pi, 3))] * 2)

    def test_arcs_that_leave_in_one_direction_are_sorted_by_where_they_go(self):
        lens = [curves.bulged(0j, 4 + 0j, bulge) for bulge in (0.2, 0.4, -0.2, -0.4)]
        areas = sorted(area for _, area in found({"a": [*lens, Segment(0, 4)]})[0])
        self.assertEqual(len(areas), 4)
        self.assertEqual(areas[0], areas[1])
        self.assertEqual(areas[2], areas[3])
        tangent = {"a": [curves.circle(1j, 1, -math.pi / 2, 1.5 * math.pi), curves.circle(2j, 2, -math.pi / 2, 1.5 * math.pi)]}
        self.assertEqual(sorted(area for _, area in found(tangent)[0]), [round(math.pi, 3), round(3 * math.pi, 3)])

    def test_a_bridge_is_a_curve_inside(self):
        faces, inner, _ = found({"a": square(0, 10), "hole": square(4 + 4j, 2), "cut": [Segment(4 + 4j, 0)]})
        self.assertEqual(faces, [("a", 96.0)])
        self.assertEqual([edge.name for edge in inner], ["cut"])

    def test_what_divides_a_hole_is_left_out_with_a_warning(self):
        faces, _, sketch = found({"a": square(0, 10), "hole": square(4 + 4j, 2), "cut": [Segment(5 + 4j, 5 + 6j)]})
        self.assertEqual(faces, [("a", 96.0)])
        self.assertEqual([code for code, _ in sketch.warnings], ["W-DRW-003"])

    def test_many_levels(self):
        layers = {f"ring{k}": [curves.circle(0, 10 - k)] for k in range(9)}
        self.assertEqual([name for name, _ in found(layers)[0]], ["ring0", "ring2", "ring4", "ring6", "ring8"])

    def test_a_hole_at_the_height_of_vertices(self):
        layers = {"a": [Segment(-4, 4), curves.circle(0, 4, 0, math.pi)], "b": square(-1 + 1j, 1)}
        self.assertEqual(found({"a": layers["a"], "b": layers["b"]})[0], [("a", round(8 * math.pi - 1, 3))])


if __name__ == "__main__":
    unittest.main()
