import json
import pathlib
import tempfile
import unittest

from bench.state import STAGES
from bench.work_folder import FILES, WorkFolder, commands_of_stages, failure_text, last_stage
from command_frame import Failure

COMMANDS = {stage: f"{stage} x\n" for stage in STAGES}


class FakeRun:
    """Writes the files of the stages from --from on and prints the report, as quadmesh would; `code` comes from `codes`
    if there are any."""

    def __init__(self, codes=(), report=None):
        self.codes, self.report, self.words = list(codes), report or {}, []

    def run(self, words):
        self.words.append(words)
        value = lambda option: words[words.index(option) + 1] if option in words else None
        code = self.codes.pop(0) if self.codes else 0
        folder, stem = pathlib.Path(value("--workdir")), pathlib.Path(words[2]).stem
        begin, end = STAGES.index(value("--from") or STAGES[0]), STAGES.index(value("--until") or STAGES[-1])
        for stage in STAGES[begin:end + 1] if not code else STAGES[begin:begin + 1]:
            if stage in FILES:
                (folder / f"{stem}.{FILES[stage]}").write_text(f"run {len(self.words)}")
        assert value("--report") == "-"
        return code, json.dumps({"warnings": [], "given_up": None, "error": "no"} | self.report), ""

    def first_stages(self):
        return [words[words.index("--from") + 1] if "--from" in words else STAGES[0] for words in self.words]


class CommandsTest(unittest.TestCase):
    def test_lines_by_stage(self):
        commands = commands_of_stages("mkdir -p w\npoints2step a.dat\ncad2tri a.step\n# fieldsolve --nodes\ncp n w/a.crit.json\n"
                                      "quadrefine a\n")
        self.assertEqual(commands["cad2tri"], "points2step a.dat\ncad2tri a.step\n")
        self.assertEqual(commands["critpoints"], "cp n w/a.crit.json\n")
        self.assertEqual((commands["fieldsolve"], commands["quadrefine"]), ("", "quadrefine a\n"))

    def test_the_last_stage_that_takes_an_option(self):
        for option, value, stage in (("--name", "a=1", 0), ("--farfield", "box:3", 0), ("--place", "energy", 3),
                                     ("--nodes", "fewest", 3), ("--nodes", "x.json", 4), ("--size", "1", 6),
                                     ("--align", "x", 6), ("--unit", "m", 7)):
            self.assertEqual(last_stage(option, value), stage, option)

    def test_messages(self):
        self.assertEqual(failure_text({"error": "too thin", "stage": "quadrefine"}, ""), "quadrefine: too thin")
        self.assertEqual(failure_text({}, "quadmesh: no\ntry"), "quadmesh: no")


class WorkFolderTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.here = pathlib.Path(folder.name)
        self.folder = WorkFolder(self.here / "found", "a")
        self.run_ = FakeRun()

    def update(self, changed=None, run=None, options=(), **more):
        self.folder.update(run or self.run_, "a.step", list(options), COMMANDS | (changed or {}), "a.msh", **more)

    def test_only_the_stages_that_changed_run(self):
        self.update()
        self.update()
        self.update({"quadrefine": "other"})
        self.update({"quadrefine": "other"})
        self.update({"critpoints": "other"})
        self.assertEqual(self.run_.first_stages(), ["cad2tri", "quadrefine", "critpoints"])
        self.assertEqual(self.folder.file("padapt").read_text(), "run 1")

    def test_options_of_stages_that_do_not_run_are_left_out(self):
        options = [("--name", "a=1"), ("--size", "2")]
        self.update(options=options)
        self.update({"quadrefine": "other"}, options=options)
        self.assertIn("--name", self.run_.words[0])
        self.assertNotIn("--name", self.run_.words[1])
        self.assertIn("--size", self.run_.words[1])

    def test_files_of_a_failed_run_are_those_before(self):
        self.update()
        with self.assertRaises(Failure) as failure:
            self.update({"blocksplit": "bad"}, FakeRun([2]))
        self.assertEqual((failure.exception.code, str(failure.exception)), (2, "quadmesh: no"))
        self.assertEqual({self.folder.file(stage).read_text() for stage in FILES}, {"run 1"})
        self.update()
        self.assertEqual(len(self.run_.words), 1)

    def test_what_the_last_stage_cannot_do_the_chain_may(self):
        self.update()
        run = FakeRun([1, 0])
        self.update({"quadrefine": "other"}, run)
        self.assertEqual(run.first_stages(), ["quadrefine", "critpoints"])
        run = FakeRun([1, 0])
        self.update({"quadrefine": "with a rule"}, run, [("--nodes", "fewest")])
        self.assertEqual(run.first_stages(), ["quadrefine", "critpoints"])
        run = FakeRun([1, 1])
        with self.assertRaises(Failure):
            self.update({"quadrefine": "third"}, run, [("--nodes", "x.json")])
        self.assertEqual(run.first_stages(), ["quadrefine", "separatrix"])

    def test_blocks_without_a_field_are_made_again(self):
        run = FakeRun(report={"given_up": "padapt: no"})
        self.update(run=run)
        self.update({"quadrefine": "other"}, run)
        self.assertEqual(run.first_stages(), ["cad2tri", "critpoints"])

    def test_warnings_of_stages_that_do_not_run_again_are_kept(self):
        first, second = ({"tool": tool, "code": "W", "message": "m"} for tool in ("cad2tri", "quadrefine"))
        self.update(run=FakeRun(report={"warnings": [first, second]}))
        self.update({"quadrefine": "other"})
        self.assertEqual(self.folder.report["warnings"], [first])

    def test_until_blocks_and_linked_files(self):
        end = STAGES.index("blocksplit") + 1
        self.update(end=end)
        self.update({"quadrefine": "other"}, end=end)
        self.assertEqual(len(self.run_.words), 1)
        self.assertIn("--until", self.run_.words[0])
        moved = WorkFolder(self.here / "moved", "a")
        moved.link(self.folder, COMMANDS)
        self.assertTrue(moved.file("cad2tri").samefile(self.folder.file("cad2tri")))
        self.assertEqual(STAGES[moved.first_changed(COMMANDS)], "critpoints")
        self.assertIsNone(moved.nodes())

    def test_names_of_meshes_keep_their_last_folders(self):
        self.assertEqual(self.folder.mesh("/a/b/constant/polyMesh/points"),
                         self.here / "found/mesh/constant/polyMesh/points")
        self.assertEqual(self.folder.mesh("x.msh").parent, self.here / "found/mesh")
