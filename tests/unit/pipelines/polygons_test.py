import unittest

from outline import polygons

SQUARE = [0, 2, 2 + 2j, 2j]


class PolygonsTest(unittest.TestCase):
    def test_the_area_is_positive_counter_clockwise(self):
        self.assertEqual(polygons.area(SQUARE), 4)
        self.assertEqual(polygons.area(SQUARE[::-1]), -4)

    def test_the_convex_hull_has_corners_only(self):
        self.assertEqual(polygons.convex_hull(SQUARE + [1 + 1j, 1, 2]), SQUARE)
        self.assertEqual(polygons.convex_hull([0, 1, 2]), [0, 2])

    def test_the_largest_distance_is_between_corners_of_the_hull(self):
        self.assertEqual(polygons.largest_distance([0, 3, 4j, 1 + 1j]), 5)
        self.assertEqual(polygons.largest_distance([1 + 1j, 1 + 1j]), 0)

    def test_the_distance_to_a_segment_is_that_to_its_end_beyond_it(self):
        self.assertEqual(polygons.distance_to_segment(1 + 1j, 0, 2), 1)
        self.assertEqual(polygons.distance_to_segment(5 + 4j, 0, 2), 5)

    def test_segments_meet_if_they_cross_or_come_as_near_as_the_tolerance(self):
        self.assertTrue(polygons.segments_meet(0, 2 + 2j, 2, 2j, 0))
        self.assertTrue(polygons.segments_meet(0, 2, 1, 1 + 1j, 0))  # an end on the other
        self.assertTrue(polygons.segments_meet(0, 2, 1 + 0.1j, 1 + 1j, 0.1))
        self.assertFalse(polygons.segments_meet(0, 2, 1 + 0.1j, 1 + 1j, 0.09))
        self.assertTrue(polygons.segments_meet(0, 2, 1, 3, 0))  # overlap
        self.assertFalse(polygons.segments_meet(0, 1, 2, 3, 0.5))

    def test_inside(self):
        notched = [0, 4, 4 + 4j, 2 + 1j, 4j]
        for z, is_inside in ((1 + 1j, True), (2 + 0.5j, True), (2 + 2j, False), (-1 + 1j, False), (5 + 1j, False)):
            self.assertEqual(polygons.is_inside(z, notched), is_inside, z)
            self.assertEqual(polygons.is_inside(z, notched[::-1]), is_inside, z)
