import unittest

from outline import fine_loops, loops, polygons
from outline.edges import Line, loop_edges


class FineLoopTest(unittest.TestCase):
    def test_it_lies_on_the_smooth_curve(self):
        circle = loops.Loop([1, 1j, -1, -1j], [1, 2, 3, 4])
        fine = fine_loops.fine_loop(loop_edges(circle))
        self.assertEqual((len(fine.points), fine.corners), (64, []))
        self.assertTrue(all(abs(fine.nearest(z) - z) < 1e-15 for z in circle.points))
        self.assertTrue(all(0.9 < abs(z) < 1.1 for z in fine.points))  # the polygon is 0.71 from the middle
        self.assertGreater(abs(fine.nearest(2 + 2j)), 0.9)

    def test_corners_know_their_shorter_edge(self):
        fine = fine_loops.fine_loop([Line(0, 2, ""), Line(2, 2 + 1j, ""), Line(2 + 1j, 0, "")])
        self.assertEqual(fine.corners, [(0, 2), (2, 1), (2 + 1j, 1)])
        self.assertEqual(polygons.nearest_on_segment(1 + 1j, 0, 2), 1)


if __name__ == "__main__":
    unittest.main()
