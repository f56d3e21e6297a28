import cmath
import math
import random
import unittest

from outline import polygons
from outline.box_tree import BoxTree


class BoxTreeTest(unittest.TestCase):
    def test_it_finds_all_pairs_that_may_meet_and_all_segments_that_a_ray_crosses(self):
        random.seed(1)
        for count in (1, 2, 3, 17, 60):
            points = [complex(random.random(), random.random()) for _ in range(count + 1)]
            segments = list(zip(points, points[1:]))
            tree = BoxTree(segments)
            near = set(tree.near_pairs(0.01))
            self.assertTrue(all(i < k for i, k in near))
            meeting = {(i, k) for i in range(count) for k in range(i + 1, count)
                       if polygons.segments_meet(*segments[i], *segments[k], 0.01)}
            self.assertLessEqual(meeting, near)
            z = complex(0.5, 0.5)
            crossed = {i for i, segment in enumerate(segments) if polygons.is_right_of(z, *segment)}
            self.assertLessEqual(crossed, set(tree.right_of(z)))
        self.assertEqual(list(BoxTree([]).near_pairs(1)), [])

    def test_it_looks_at_few_pairs_of_a_long_polygon(self):
        circle = [cmath.rect(1, 2 * math.pi * k / 4096) for k in range(4097)]
        self.assertLess(len(list(BoxTree(list(zip(circle, circle[1:]))).near_pairs(1e-9))), 4200)


if __name__ == "__main__":
    unittest.main()
