import math
import unittest

from node_search.goals import GOALS, upper_bound
from node_search.layouts import Layout

NODES = {"critical_points": [{"position": [0.5, 0.0], "valence": 5}], "corners": []}


def layout(quality, edge_ratio=1.0, num_blocks=1, misalignment=20.0):
    return Layout(NODES, None, quality, edge_ratio, num_blocks, misalignment)


class GoalsTest(unittest.TestCase):
    def test_the_bound_is_the_sine_of_the_best_possible_smallest_angle(self):
        self.assertAlmostEqual(upper_bound(NODES), math.sin(math.radians(72)))
        corner = {"angle_degrees": 60, "valence": 1}
        self.assertAlmostEqual(upper_bound(NODES | {"corners": [corner]}), math.sin(math.radians(60)))
        self.assertEqual(upper_bound({"critical_points": [], "corners": [{"angle_degrees": 10, "valence": 0}]}), 1)

    def test_each_goal_prefers_its_own_figure(self):
        start = layout(0.5, 8, 12)
        for name, better in (("scaled-jacobian", layout(0.6, 9, 13)), ("edge-ratio", layout(0.4, 7, 13)),
                             ("blocks", layout(0.4, 9, 11)), ("alignment", layout(0.4, 9, 13, 19.0))):
            for other, goal in GOALS.items():
                self.assertEqual(goal.is_better(better, start, start), other == name, (name, other))

    def test_of_as_many_blocks_the_better_shape_counts(self):
        self.assertTrue(GOALS["blocks"].is_better(layout(0.6, 9, 12), layout(0.5, 8, 12), layout(0.5)))

    def test_no_goal_accepts_invalid_blocks_or_half_the_shape_at_the_start(self):
        for worse in (layout(0, 1, 1), layout(0.24, 1, 1)):
            for goal in GOALS.values():
                self.assertFalse(goal.is_better(worse, layout(0, 8, 12), layout(0.5)))

    def test_a_goal_is_reached_where_no_positions_can_be_better(self):
        self.assertTrue(GOALS["scaled-jacobian"].is_reached(layout(math.sin(math.radians(72)))))
        self.assertTrue(GOALS["edge-ratio"].is_reached(layout(0.5, 1)))
        self.assertFalse(GOALS["edge-ratio"].is_reached(layout(0.5, 1.1)))
        self.assertFalse(GOALS["blocks"].is_reached(layout(0.5, 1, 2)))
        self.assertTrue(GOALS["alignment"].is_reached(layout(0.5, misalignment=0)))
        self.assertFalse(GOALS["alignment"].is_reached(layout(0.5)))
