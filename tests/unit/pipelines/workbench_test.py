import json
import pathlib
import tempfile
import unittest
from unittest import mock

from bench.processes import Overtaken
from bench.saved_files import SavedFiles
from bench.workbench import Made, Workbench, is_of_critpoints_alone, places_of, with_moves
from command_frame import Failure

NODES = {"form": "harmonic", "origin": [10, 0],
         "critical_points": [{"position": [1, 2], "valence": 3, "error": 1}, {"position": [3, 4], "valence": 5}],
         "corners": [{"position": [0, 0], "valence": 1, "curves": [2, 0]}]}


class MovesTest(unittest.TestCase):
    def test_nodes_move_one_after_another_in_coordinates_of_the_file(self):
        nodes = with_moves(NODES, [(11 + 2j, 12 + 2j), (12 + 2j, 12 + 3j)], 1.0)
        self.assertEqual(nodes["form"], "phase")
        self.assertEqual(nodes["critical_points"][0], {"position": [2, 3], "valence": 3, "source": "hand"})
        self.assertEqual(nodes["critical_points"][1], NODES["critical_points"][1])
        self.assertEqual(NODES["form"], "harmonic")

    def test_a_node_that_is_not_there_is_refused(self):
        for start in (11.001 + 2j, 0j):
            with self.assertRaises(Failure):
                with_moves(NODES, [(start, 12j)], 1.0)
        with self.assertRaises(Failure):
            with_moves(None, [(1j, 2j)], 1.0)
        with self.assertRaises(Failure):
            with_moves(NODES | {"critical_points": []}, [(1j, 2j)], 1.0)

    def test_places_for_the_page(self):
        places = places_of(NODES)
        self.assertEqual(places["nodes"][0], {"position": [11, 2], "valence": 3})
        self.assertEqual(places["corners"], [{"position": [10, 0], "valence": 1, "curves": [2, 0]}])
        self.assertEqual(places_of(None), {"nodes": [], "corners": []})

    def test_options_that_given_nodes_replace(self):
        self.assertEqual([is_of_critpoints_alone(option) for option in ("--place", "--nodes", "--size", "--symmetry", "--name")],
                         [True, True, False, False, False])


class AnswersTest(unittest.TestCase):
    """Of a workbench whose runs are replaced."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.here = pathlib.Path(folder.name)
        saved = SavedFiles(self.here / "a.step", self.here, self.here / "a.msh", [])
        (self.here / "scratch").mkdir()
        self.bench = Workbench(self.here / "a.step", [], saved, self.here / "scratch", {})
        self.bench.found.report = {"quads": 3, "warnings": [{"tool": "cad2tri", "message": "m", "code": "W"}]}
        self.nodes_text = None
        self.bench.made = lambda run, state: Made(self.bench.found, [("--size", "1")], self.nodes_text)
        self.bench.page = lambda *_: '{"sheets": []}'

    def test_a_run(self):
        answer = json.loads(self.bench.run(1, {}))
        self.assertEqual({key: answer[key] for key in ("number", "ok", "page", "warnings", "command")},
                         {"number": 1, "ok": True, "page": {"sheets": []}, "warnings": ["cad2tri: m"],
                          "command": "quadmesh a.step --size 1 -o a.msh"})
        self.assertEqual(answer["report"]["quads"], 3)

    def test_failures(self):
        for error, part in ((Failure(1, "too thin"), "too thin"), (ValueError("x"), "internal error"), (OSError(28, "full"), "full")):
            with mock.patch.object(self.bench, "made", side_effect=error):
                answers = [self.bench.run(self.bench.processes.newest + 1, {}), self.bench.save({}, "command")]
            for answer in map(json.loads, answers):
                self.assertFalse(answer["ok"])
                self.assertIn(part, answer["message"])

    def test_an_older_run(self):
        self.bench.run(2, {})
        self.assertEqual(json.loads(self.bench.run(1, {})), {"number": 1, "ok": False, "overtaken": True})
        with mock.patch.object(self.bench, "made", side_effect=Overtaken):
            self.assertIn("save it again", json.loads(self.bench.save({}, "command"))["message"])

    def test_moved_nodes_are_saved_with_the_command(self):
        self.nodes_text = "{}\n"
        self.assertEqual(json.loads(self.bench.save({}, "makefile"))["file"], "a.mk")
        self.assertEqual((self.here / "a.crit.json").read_text(), "{}\n")
        self.assertIn("a.step a.crit.json", (self.here / "a.mk").read_text())

    def test_found_nodes_are_saved_alone(self):
        self.assertIn("none to save", json.loads(self.bench.save({}, "nodes"))["message"])
        self.bench.found.file("critpoints").write_text("{}\n")
        self.assertEqual(json.loads(self.bench.save({}, "nodes")), {"ok": True, "file": "a.crit.json", "text": "{}\n"})
        self.assertEqual((self.here / "a.crit.json").read_text(), "{}\n")
