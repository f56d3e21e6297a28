"""Keywords as words of a command line, by the kinds of options that the tools list."""
import pathlib
import unittest

import numpy as np

import quadrille
from quadrille.memory_files import MemoryFiles
from quadrille.tool_words import option_words


def words(tool="quadmesh", **options):
    with MemoryFiles() as files:
        return option_words(tool, options, files)


class WordsTest(unittest.TestCase):
    def test_values(self):
        self.assertEqual(words(size=0.1, order=np.int64(3), growth=np.float32(1.5)),
                         ["--size", "0.1", "--order", "3", "--growth", "1.5"])
        self.assertEqual(words(boundary_names=pathlib.Path("a.json"), place="energy", size=None),
                         ["--boundary-names", "a.json", "--place", "energy"])
        self.assertEqual(words(axis=(-3, 0, -3, 1), blocks=["a", 2]), ["--axis", "-3,0,-3,1", "--blocks", "a,2"])
        self.assertEqual(words(top_layers={"first": 0.1, "layers": 3}), ["--top-layers", "first=0.1,layers=3"])

    def test_flags(self):
        self.assertEqual(words(sweep=True, allow_invalid=False), ["--sweep"])

    def test_options_that_may_be_given_several_times(self):
        self.assertEqual(words(walls={"hole": {"first": 1e-3, "layers": "fit"}, "a,b": {"yplus": 1}}),
                         ["--wall", "hole:first=0.001,layers=fit", "--wall", "a,b:yplus=1"])
        self.assertEqual(words(size_near={"hole": 0.02, "wake": (0.1, 1)}, counts={"inlet": 24}),
                         ["--size-near", "hole=0.02", "--size-near", "wake=0.1:1", "--count", "inlet=24"])
        self.assertEqual(words(names={"wall": [1, "3-6"], "axis": "edge_*"}), ["--name", "wall=1,3-6", "--name", "axis=edge_*"])
        self.assertEqual(words(name=["left@0,1", "right@3,1"], open="crack"),
                         ["--name", "left@0,1", "--name", "right@3,1", "--open", "crack"])
        self.assertEqual(words(corner_valences={(0, 1): 2}), ["--corner-valence", "0:1=2"])

    def test_files_are_paths_or_content(self):
        with MemoryFiles() as files:
            name, path = option_words("quadmesh", {"size_field": {"format": "size-field"}}, files)
            self.assertEqual((name, pathlib.Path(path).read_bytes()), ("--size-field", b'{"format": "size-field"}'))
            name, path = option_words("quadmesh", {"nodes": b"{}"}, files)
            self.assertEqual((name, pathlib.Path(path).read_bytes()), ("--nodes", b"{}"))

    def test_mistakes_are_named_with_the_nearest_option(self):
        for options, text in (({"siz": 1}, "there is no option siz: did you mean size?"),
                              ({"size_nears": 1, "wals": 2}, "there is no option wals: did you mean wall?"),
                              ({"xyzzy": 1}, "there is no option xyzzy: quadmesh --help lists them"),
                              ({"sweep": 1}, "sweep: expected True or False, not 1"),
                              ({"size": True}, "size: expected a value, not True")):
            with self.assertRaises(quadrille.ToolError) as caught:
                words(**options)
            self.assertEqual((caught.exception.code, caught.exception.text), (2, text))


if __name__ == "__main__":
    unittest.main()
