import unittest

from command_frame import Failure
from outline import loops
from outline.loops import Loop
from outline.point_files import PointFile

FILE = PointFile("points", "")


def loop(*points, first_line=1):
    return Loop(list(points), list(range(first_line, first_line + len(points))))


class LoopTest(unittest.TestCase):
    def test_reversing_moves_names_with_their_segments_and_marks_with_their_points(self):
        a = loop(0, 1, 1 + 1j)
        a.names, a.corners, a.joints = ["0-1", "1-2", "2-0"], {0, 1}, {2}
        a.reverse()
        self.assertEqual(a.points, [1 + 1j, 1, 0])
        self.assertEqual(a.lines, [3, 2, 1])
        self.assertEqual(a.names, ["1-2", "0-1", "2-0"])
        self.assertEqual((a.corners, a.joints), ({2, 1}, {0}))

    def test_a_repeated_first_point_is_removed(self):
        closed, open_ = loop(0, 1, 1j, 0), loop(0, 1, 1j)
        self.assertEqual(loops.close(FILE, closed, 1e-9), (True, []))
        self.assertEqual(loops.close(FILE, open_, 1e-9), (False, []))
        for a in (closed, open_):
            self.assertEqual((a.points, a.lines, len(a.names)), ([0, 1, 1j], [1, 2, 3], 3))

    def test_repeated_points_are_left_out_and_loops_of_two_points_refused(self):
        with self.assertRaisesRegex(Failure, "line 1: a loop needs three different points, this one has 2"):
            loops.close(FILE, loop(0, 1, 1, 0), 1e-9)
        repeated = loop(0, 1, 1 + 1e-10j, 1j, 0, 1e-10)
        self.assertEqual(loops.close(FILE, repeated, 1e-9), (True, [3, 5]))
        self.assertEqual((repeated.points, repeated.lines), ([0, 1, 1j], [1, 2, 4]))


class CrossingsTest(unittest.TestCase):
    def test_a_loop_that_turns_back_is_refused(self):
        with self.assertRaisesRegex(Failure, "line 2: the loop turns back on itself"):
            loops.refuse_reversals(FILE, loop(0, 2, 1, 1 + 1j), 1e-9)
        loops.refuse_reversals(FILE, loop(0, 1, 2, 1j), 1e-9)  # straight on is allowed

    def test_crossings_within_a_loop_and_between_loops_are_refused_with_the_line_of_the_later_segment(self):
        loops.refuse_crossings(FILE, [loop(0, 4, 4 + 4j, 4j), loop(1 + 1j, 2 + 1j, 1 + 2j)], 1e-9)
        with self.assertRaisesRegex(Failure, "line 4: the loop crosses or touches itself: .* from line 2"):
            loops.refuse_crossings(FILE, [loop(0, 2, 2j, 2 + 2j)], 1e-9)
        with self.assertRaisesRegex(Failure, "line 6: two loops cross or touch: .* from line 2"):
            loops.refuse_crossings(FILE, [loop(0, 4, 4 + 4j, 4j), loop(3 + 1j, 5 + 1j, 5 + 2j, first_line=6)], 1e-9)


class ArrangeTest(unittest.TestCase):
    def test_the_largest_loop_is_the_outline_and_counter_clockwise_holes_are_clockwise(self):
        hole, outline = loop(1 + 1j, 2 + 1j, 1 + 2j), loop(4j, 4 + 4j, 4, 0)
        self.assertEqual(loops.arrange(FILE, [hole, outline], False), [outline, hole])
        self.assertEqual(outline.points, [0, 4, 4 + 4j, 4j])
        self.assertEqual(hole.points, [1 + 2j, 2 + 1j, 1 + 1j])

    def test_with_a_far_field_every_loop_is_a_hole(self):
        a, b = loop(0, 1, 1j), loop(5, 7, 5 + 2j)
        self.assertEqual(loops.arrange(FILE, [a, b], True), [a, b])
        self.assertEqual(b.points, [5 + 2j, 7, 5])

    def test_holes_lie_inside_the_outline_and_not_inside_each_other(self):
        outline = 0, 9, 9 + 9j, 9j
        with self.assertRaisesRegex(Failure, "line 5: this loop is not inside the largest one"):
            loops.arrange(FILE, [loop(*outline), loop(10, 11, 11j + 11, first_line=5)], False)
        inner, outer = loop(2 + 2j, 3 + 2j, 2 + 3j, first_line=5), loop(1 + 1j, 8 + 1j, 1 + 8j, first_line=9)
        with self.assertRaisesRegex(Failure, "line 5: this loop lies inside the hole that begins in line 9"):
            loops.arrange(FILE, [loop(*outline), inner, outer], False)
