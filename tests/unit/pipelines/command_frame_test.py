import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import command_frame
from command_frame import Failure

KINDS = {"--output": "value", "--size": "value", "--verbose": "flag"}


def pairs(*words):
    return list(command_frame.option_pairs(words, KINDS.get))


def run(work):
    """What a command does whose work is this Python text."""
    code = f"import command_frame as frame, os, signal\ndef work():\n  {work}\nframe.run_command('tool', work)\n"
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True,
                          env=os.environ | {"PYTHONPATH": str(pathlib.Path(command_frame.__file__).parent)})


class OptionsTest(unittest.TestCase):
    def test_options_flags_and_words(self):
        self.assertEqual(pairs("a", "-o", "b", "--size=1=2", "-v", "-"),
                         [(None, "a"), ("--output", "b"), ("--size", "1=2"), ("--verbose", None), (None, "-")])

    def test_bundled_short_options(self):
        self.assertEqual(pairs("-vob", "-o=b", "-vv"),
                         [("--verbose", None), ("--output", "b"), ("--output", "=b"), ("--verbose", None),
                          ("--verbose", None)])

    def test_mistakes(self):
        for words, message in ((["--none"], "unknown option --none"), (["-x"], "unknown option -x"),
                               (["a", "--size"], "--size needs a value"), (["-vx"], "unknown option -x"),
                               (["--size", "--verbose"], "--size needs a value, not the option --verbose"),
                               (["--verbose=3"], "--verbose takes no value")):
            with self.assertRaises(Failure) as raised:
                pairs(*words)
            self.assertEqual((raised.exception.code, str(raised.exception)), (2, message))

    def test_the_nearest_option(self):
        with self.assertRaisesRegex(Failure, "^unknown option --sise: did you mean --size\\?$"):
            list(command_frame.option_pairs(["--sise"], KINDS.get, lambda: KINDS))

    def test_numbers(self):
        self.assertEqual(command_frame.number("--x", "1e3", 0, 1e3), 1000)
        self.assertEqual(command_frame.number("--x", "0", 0, 5, int), 0)
        for text, kind, is_open in (("x", float, False), ("1.5", int, False), ("6", int, False), ("0", float, True),
                                    ("nan", float, False)):
            with self.assertRaisesRegex(Failure, "^--x: "):
                command_frame.number("--x", text, 0, 5, kind, is_open)


class FilesTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "shape").write_text("text")
        (self.folder / "link").symlink_to("shape")
        (self.folder / "empty").touch()

    def code_of(self, function, *arguments):
        with self.assertRaises(Failure) as raised:
            function(*arguments)
        return raised.exception.code

    def test_inputs(self):
        command_frame.require_input("-")
        command_frame.require_input(str(self.folder / "link"))
        for name in ("empty", "missing", "."):
            self.assertEqual(self.code_of(command_frame.require_input, str(self.folder / name)), 3)

    def test_outputs(self):
        name = lambda path: str(self.folder / path)
        command_frame.require_outputs([None, "-", name("new"), "/dev/null"], ["-", name("shape")])
        for path in ("shape", "link", "./shape"):
            self.assertEqual(self.code_of(command_frame.require_outputs, [name(path)], ["-", name("shape")]), 2)
        self.assertEqual(self.code_of(command_frame.require_outputs, [name("new"), name("./new")], []), 2)
        self.assertEqual(self.code_of(command_frame.require_outputs, [name("no/new")], []), 4)
        self.assertEqual(self.code_of(command_frame.require_outputs, [name(".")], []), 4)


class CountsTest(unittest.TestCase):
    def test_one_is_singular(self):
        self.assertEqual([command_frame.counted(n, "trial") for n in (0, 1, 2)], ["0 trials", "1 trial", "2 trials"])


class WriteFileTest(unittest.TestCase):
    def test_a_file_is_replaced_whole_or_stays(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "file")
            command_frame.write_file(path, "old")
            command_frame.write_file(path, "new")
            self.assertEqual(os.listdir(folder), ["file"])
            self.assertEqual(pathlib.Path(path).read_text(), "new")
            with self.assertRaises(Failure) as raised:
                command_frame.write_file(os.path.join(folder, "no", "file"), "")
            self.assertEqual(raised.exception.code, 4)
            with self.assertRaises(Failure):
                command_frame.write_file(folder, "")
            self.assertEqual(os.listdir(folder), ["file"])


class RunCommandTest(unittest.TestCase):
    def check(self, work, code, err, out=""):
        done = run(work)
        self.assertEqual((done.returncode, done.stderr, done.stdout), (code, err, out))

    def test_exit_codes_and_messages(self):
        self.check("print('text')", 0, "", "text\n")
        self.check("raise frame.mistake('wrong')", 2, "tool: wrong\ntry 'tool --help'\n")
        self.check("raise frame.Failure(3, 'bad input')", 3, "tool: bad input\n")
        self.check("raise frame.Failure(1)", 1, "")
        self.check("open('/no/file', 'w')", 4, "tool: /no/file: cannot be written: No such file or directory\n")
        self.check("1 / 0", 70, "tool: internal error, please report it: ZeroDivisionError('division by zero')\n")

    def test_a_signal_ends_it_by_that_signal(self):
        for signum in command_frame.SIGNALS:
            self.check(f"os.kill(os.getpid(), {int(signum)}); signal.pause()", -signum, "")
