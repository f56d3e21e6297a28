import json
import pathlib
import tempfile
import unittest
from unittest import mock

from command_frame import Failure
from node_search import compass_search, goals
from node_search.compass_search import Search, directions, moved_nodes, node_positions
from node_search.goals import GOALS
from node_search.layouts import Layout
from node_search.symmetries import Orbit

CORNERS = [2 + 1j, -2 + 1j, -2 - 1j, 2 - 1j]
NODES = {"form": "harmonic", "corners": [], "critical_points": [{"position": [0.5, 0.0], "valence": 5, "bound": 1},
                                                                {"position": [-0.5, 0.0], "valence": 5, "bound": 1}]}


class NodesTest(unittest.TestCase):
    def test_a_moved_node_is_written_as_by_hand_and_needs_a_field_of_its_own(self):
        moved = moved_nodes(NODES, {1: 0.25j})
        self.assertEqual(moved["form"], "phase")
        self.assertEqual(moved["critical_points"][0], NODES["critical_points"][0])
        self.assertEqual(moved["critical_points"][1], {"position": [-0.5, 0.25], "valence": 5, "source": "hand"})
        self.assertEqual(NODES["form"], "harmonic")

    def test_directions_are_those_that_symmetry_allows(self):
        anywhere, on_axis = Orbit(0, {}, [lambda z: z]), Orbit(0, {}, [lambda z: z, lambda z: z.conjugate()])
        self.assertEqual(directions(0, [3, 4j], anywhere), [1, -1, 1j, -1j])
        self.assertEqual(directions(0, [3, 4j], on_axis), [1, -1])


class SearchTest(unittest.TestCase):
    """With an invented quality: 0.9 less the distances of the nodes from (1, 0) and (-1, 0)."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.first = pathlib.Path(self.folder.name)
        self.lines = []
        patch = mock.patch.object(compass_search.layouts, "make_layout", self.make_layout)
        patch.start()
        self.addCleanup(patch.stop)
        self.addCleanup(self.folder.cleanup)

    def make_layout(self, nodes, folder, first, is_trial):
        folder.mkdir()
        a, b = node_positions(nodes)
        if abs(a) > 1.9:
            raise Failure(1)
        return Layout(nodes, folder, 0.9 - (abs(a - 1) + abs(b + 1)) / 10, 1 + abs(a - 0.1))

    def test_a_search_that_moves_nothing_has_a_reason(self):
        search = self.search()
        self.assertEqual(search.reason_to_stay(0), "no round was allowed")
        search.trials = 3
        self.assertRegex(search.reason_to_stay(1), "^no trial gave blocks")
        search.num_layouts = 1
        self.assertRegex(search.reason_to_stay(1), "^no trial raised it")
        search.orbits = []
        self.assertRegex(search.reason_to_stay(1), "^there is no irregular node")

    def search(self, goal=GOALS["scaled-jacobian"]):
        start = self.make_layout(NODES, self.first / "start", self.first, False)
        lines = [{"degree": 1, "knots": [0, 0, 1, 1], "poles": [[a.real, a.imag], [b.real, b.imag]], "weights": [1, 1]}
                 for a, b in zip(CORNERS, CORNERS[1:] + CORNERS[:1])]
        nodes = [{"kind": "corner", "valence": 1, "position": [z.real, z.imag]} for z in CORNERS]
        nodes += [{"kind": "irregular", "valence": 5, "position": [x, 0]} for x in (0.5, -0.5)]
        graph = {"face": {"diameter": 4.0, "curves": lines}, "nodes": nodes}
        (start.folder / "sep.json").write_text(json.dumps(graph))
        return Search(self.first, start, self.lines.append, goal)

    def test_symmetric_nodes_move_together_to_the_best_place(self):
        search = self.search()
        search.run(20, 0.05)
        a, b = node_positions(search.best.nodes)
        self.assertAlmostEqual(a, -b, 12)
        self.assertLess(abs(a - 1), 2e-3)
        self.assertEqual(len(self.lines), len(search.moves))
        self.assertEqual([move["nodes"] for move in search.moves], [[0, 1]] * len(search.moves))
        self.assertEqual(search.moves[-1]["quality"], search.best.quality)

    def test_only_the_files_of_the_best_layout_are_left(self):
        search = self.search()
        search.run(3, 0.05)
        self.assertEqual(list(self.first.iterdir()), [search.best.folder])

    def test_a_round_without_gain_halves_the_step_and_a_failing_trial_is_no_gain(self):
        search = self.search()
        self.assertEqual(search.run(1, 0.4), 1)  # steps of 1.6: outside, or too far
        self.assertEqual((search.moves, search.best.nodes), ([], NODES))
        search.run(3, 0.4)
        self.assertEqual(search.moves[0]["step"], 0.2)

    def test_no_round_is_made_where_nothing_can_be_gained(self):
        with mock.patch.object(goals, "upper_bound", lambda nodes: 0.8):
            self.assertEqual(self.search().run(5, 0.05), 0)

    def test_another_goal_moves_the_nodes_elsewhere(self):
        search = self.search(GOALS["edge-ratio"])  # that falls towards (0.1, 0)
        search.run(20, 0.05)
        a = node_positions(search.best.nodes)[0]
        self.assertLess(abs(a - 0.1), 2e-3)
        self.assertEqual(search.moves[-1]["quality"], search.best.edge_ratio)
        self.assertGreaterEqual(search.best.quality, search.start.quality / 2)
