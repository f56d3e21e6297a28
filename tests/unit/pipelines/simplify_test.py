import unittest

from outline import polygons, simplify
from outline.loops import Loop

COAST = [complex(k / 10, 5 + 0.02 * (-1) ** k) for k in range(100, -1, -1)]
BASIN = [0, 10, *COAST]


def loop(points):
    return Loop(list(points), list(range(1, len(points) + 1)))


class SimplifyTest(unittest.TestCase):
    def test_noise_goes_and_walls_keep_their_ends(self):
        kept = simplify.kept_points(BASIN, 0.05)
        self.assertEqual([BASIN[i] for i in kept], [0, 10, 10 + 5.02j, 5.02j])
        self.assertLessEqual(simplify.distance_left_out(BASIN, kept), 0.05)
        self.assertEqual(simplify.kept_points(BASIN, 0.01), list(range(len(BASIN))))
        jetty = [0, 4, 4 + 2j, 4.1 + 2j, 4.1, 10, *COAST]  # is narrower than the tolerance
        self.assertEqual(simplify.kept_points(jetty, 0.15)[:6], [0, 1, 2, 3, 4, 5])

    def test_the_tolerance_is_kept_and_so_are_fixed_points_and_small_loops(self):
        wave = [complex(k, 3 * (k % 7)) for k in range(50)] + [49 + 40j, 40j]
        kept = simplify.kept_points(wave, 2, fixed=[11])
        self.assertIn(11, kept)
        self.assertLess(len(kept), len(wave))
        self.assertLessEqual(simplify.distance_left_out(wave, kept), 2)
        self.assertEqual(len(simplify.kept_points(BASIN, 50)), len(BASIN))

    def test_simplified_loops_do_not_cross(self):
        # An island in a bay that the tolerance closes.
        bay = [0, 4, 5 + 1j, 6, 10, 10 + 9j, 9j]
        island = [4.9 + 0.4j, 5.1 + 0.4j, 5 + 0.6j]
        self.assertEqual(simplify.kept_points([bay[0], 4, 5 + 1j, 6, 10, 10 + 9j, 9j], 1.2, fixed=[0, 4]), [0, 4, 5, 6])
        outer = loop(bay)
        hole = loop([5 + 0.5j, 5.2 - 0.5j, 4.8 - 0.5j])
        kept = simplify.simplified([outer, hole], 1.2, 1e-9, [[0, 4], ()])
        made = [simplify.part_of(given, positions) for given, positions in zip((outer, hole), kept)]
        segments = list(zip(made[0].points, made[0].points[1:] + made[0].points[:1]))
        self.assertFalse(any(polygons.segments_meet(a, b, c, d, 1e-9) for a, b in segments
                             for c, d in zip(hole.points, hole.points[1:] + hole.points[:1])))
        self.assertEqual(len(island), 3)


if __name__ == "__main__":
    unittest.main()
