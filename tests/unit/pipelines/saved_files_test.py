import os
import pathlib
import subprocess
import tempfile
import unittest

from bench.saved_files import SavedFiles, relocated
from command_frame import Failure


class SavedFilesTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.here = pathlib.Path(folder.name).resolve()
        self.shape = self.here / "a b.step"
        self.shape.touch()
        self.saved = SavedFiles(self.shape, self.here, self.here / "a.msh", [str(self.shape)])

    def test_names_of_files_are_those_of_the_folder(self):
        self.assertEqual(relocated(self.here / "x/y", self.here), "x/y")
        self.assertEqual(relocated(self.here / "-x", self.here), "./-x")
        self.assertEqual(relocated("/etc/hosts", self.here), "/etc/hosts")
        sizes = str(self.here / "sizes.csv")
        self.assertEqual(self.saved.words([("--size-field", sizes), ("--nodes", "fewest"), ("--nodes", str(self.here / "n"))]),
                         ["quadmesh", "a b.step", "--size-field", "sizes.csv", "--nodes", "fewest", "--nodes", "n", "-o", "a.msh"])

    def test_a_script_runs_the_words_in_its_folder(self):
        name = self.saved.write("command", self.saved.script([("--name", "it's=1")]))
        self.assertEqual(name, "a b.quadmesh.sh")
        (self.here / "quadmesh").write_text('#!/bin/sh\nprintf "%s\\n" "$PWD" "$@"\n')
        (self.here / "quadmesh").chmod(0o755)
        done = subprocess.run([self.here / name], env={"PATH": f"{self.here}:/usr/bin:/bin"}, cwd="/", capture_output=True,
                              text=True, check=True)
        self.assertEqual(done.stdout.splitlines(), [str(self.here), "a b.step", "--name", "it's=1", "-o", "a.msh"])

    def test_a_rule_of_a_makefile(self):
        saved = SavedFiles(self.here / "a.step", self.here, self.here / "a.msh", [])
        self.assertEqual(saved.makefile([("--name", "a$b=1")], True),
                         "# Meshes a.step; saved by quadbench.\na.msh: a.step a.crit.json\n"
                         "\tquadmesh a.step --name 'a$$b=1' -o a.msh\n")
        with self.assertRaises(Failure):
            self.saved.makefile([], False)

    def test_no_input_is_replaced_and_nothing_outside_the_folder(self):
        saved = SavedFiles(self.here / "a.step", self.here, "a.msh", [str(self.here / "a.crit.json")])
        (self.here / "a.crit.json").write_text("mine")
        with self.assertRaises(Failure):
            saved.write("nodes", "{}")
        self.assertEqual((self.here / "a.crit.json").read_text(), "mine")
        (self.here / "inside").mkdir()
        inside = SavedFiles(self.here / "a.step", self.here / "inside", "a.msh", [])
        os.symlink(self.here / "outside", self.here / "inside/a.mk")
        with self.assertRaises(Failure):
            inside.write("makefile", "x")
        self.assertFalse((self.here / "outside").exists())

    def test_what_was_saved_before_is_replaced(self):
        self.saved.write("makefile", "first")
        self.assertEqual((self.here / self.saved.write("makefile", "second")).read_text(), "second")
        self.assertEqual(sorted(os.listdir(self.here)), ["a b.mk", "a b.step"])
