import unittest

from bench.state import empty_state, is_for_page, moves_of, options_of, state_of, words_of
from command_frame import Failure


class OptionsTest(unittest.TestCase):
    def test_every_key_has_its_option(self):
        state = {"names": [{"curves": [3, 4], "name": "wall"}, {"selector": "circles(<5)", "name": "bolts"},
                           {"selector": "@0,1", "name": "top"}],
                 "size": 0.1, "near": {"wall": 0.02, "wake": "0.1:1"}, "walls": {"wall": "first=0.01,growth=1.2,layers=5"},
                 "valences": [{"corner": ["A", 2], "valence": 2}], "options": ["--order", "3", "--allow-invalid"]}
        self.assertEqual(options_of(state), [
            ("--name", "wall=3,4"), ("--name", "bolts=circles(<5)"), ("--name", "top@0,1"), ("--size", "0.1"),
            ("--size-near", "wall=0.02"), ("--size-near", "wake=0.1:1"), ("--wall", "wall:first=0.01,growth=1.2,layers=5"),
            ("--corner-valence", "A:2=2"), ("--order", "3"), ("--allow-invalid", None)])
        self.assertEqual(options_of({}), [])

    def test_a_value_cannot_become_an_option(self):
        options = options_of({"options": ["--translate", "-o", "--unit", "m"], "names": [{"curves": [0], "name": "-o"}]})
        self.assertEqual(words_of(options), ["--name=-o=0", "--translate=-o", "--unit", "m"])

    def test_the_page_names_no_file_and_no_program(self):
        for words in (["-o", "x.msh"], ["--workdir", "/tmp"], ["--stage", "cad2tri=rm"], ["--nodes", "x.json"],
                      ["--size-field", "x"], ["--boundary-names", "x"], ["--report", "x"], ["--face", "1"],
                      ["--write-healed", "x.step"], ["word"], ["--size", "1"], ["--unknown"], ["--order"]):
            with self.assertRaises(Failure, msg=words):
                options_of({"options": words})
        self.assertTrue(is_for_page("--nodes", "fewest"))

    def test_what_is_no_state_is_refused(self):
        for state in (None, [], {"name": []}, {"names": {}}, {"size": "big"}, {"size": True}, {"size": float("inf")},
                      {"near": {"wall": []}}, {"near": {"": 1}}, {"walls": {"a": "b\n"}}, {"walls": {"a": "x" * 5000}},
                      {"names": [{"name": "a"}]}, {"names": [{"curves": [], "name": "a"}]}, {"names": [3]},
                      {"names": [{"curves": ["0"], "name": "a"}]}, {"names": [{"curves": [-1], "name": "a"}]},
                      {"names": [{"selector": "4", "name": "a", "more": 1}]},
                      {"valences": [{"corner": ["A"], "valence": 1}]}, {"valences": [{"corner": "AB", "valence": 1}]},
                      {"valences": [{"corner": ["A", "B"], "valence": 1.5}]}, {"options": [3]}):
            with self.assertRaises(Failure, msg=state):
                options_of(state)

    def test_moves(self):
        self.assertEqual(moves_of({"moves": [{"node": [1, 2.5], "to": [3, 4]}]}), [(1 + 2.5j, 3 + 4j)])
        self.assertEqual(moves_of({}), [])
        for move in ({"node": [1, 2]}, {"node": [1], "to": [1, 2]}, {"node": [1, None], "to": [1, 2]}, [1, 2, 3, 4]):
            with self.assertRaises(Failure):
                moves_of({"moves": [move]})


class CommandLineTest(unittest.TestCase):
    def test_options_become_the_state_that_gives_them(self):
        options = [("--name", "wall=3,4"), ("--name", "top@0,1"), ("--size-near", "wall=0.1"), ("--wall", "wall:first=1,layers=2"),
                   ("--corner-valence", "A:B=2"), ("--order", "3")]
        state, others = state_of(options)
        self.assertEqual(others, [])
        self.assertEqual(options_of(state), options)

    def test_what_the_page_cannot_set_is_kept_apart(self):
        others = [("--face", "3"), ("--size-field", "x"), ("--nodes", "x.crit.json"), ("--threads", "1")]
        self.assertEqual(state_of(others), (empty_state(), others))

    def test_mistakes(self):
        for option in (("--size", "big"), ("--size", "0"), ("--size-near", "wall"), ("--wall", "wall"), ("--name", "4"),
                       ("--corner-valence", "A:B=x")):
            with self.assertRaises(Failure, msg=option):
                state_of([option])
        with self.assertRaises(Failure):
            state_of([("--wall", "a:first=1,layers=1"), ("--wall", "a:first=2,layers=1")])
