import json
import os
import pathlib
import tempfile
import unittest

from command_frame import Failure
from many_shapes.shape_results import Results, message_of, read_row, shape_files

REPORT = {"blocks": 4, "quads": 10, "irregular_nodes": 2, "least_scaled_jacobian": 0.5,
          "greatest_edge_ratio": {"value": 3.0, "element": 1}, "resolution": {"ratio": 1.5},
          "warnings": [{"code": "W-X-2"}, {"code": "W-X-1"}] * 2}


class FolderTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.here = pathlib.Path(self.folder.name)


class ShapeFilesTest(FolderTest):
    def test_files_and_folders(self):
        for name in ("b.STEP", "a.iges", "notes.txt"):
            (self.here / name).touch()
        self.assertEqual(shape_files(["x.step", str(self.here)]),
                         ["x.step", str(self.here / "a.iges"), str(self.here / "b.STEP")])
        (self.here / "empty").mkdir()
        with self.assertRaises(Failure):
            shape_files([str(self.here / "empty")])


class ResultsTest(FolderTest):
    def setUp(self):
        super().setUp()
        self.shape = self.here / "disc.step"
        self.results = Results(self.here / "out", "msh", ["--size", "1"], "0.1")
        self.results.folder.mkdir()
        self.shape.write_text("a face")

    def finish(self, exit_code=0, results=None):
        results = results or self.results
        row = self.new_row(exit_code, results=results)
        for path in (results.mesh(self.shape), results.report(self.shape)):
            path.touch()
        results.row_file(self.shape).write_text(json.dumps(row))

    def new_row(self, exit_code, message="", results=None):
        results = results or self.results
        return results.new_row(self.shape, results.digests(self.shape), exit_code, 0.25, message,
                               REPORT if exit_code == 0 else None)

    def is_done(self, results=None):
        return (results or self.results).row(str(self.shape)) is not None

    def test_a_row_has_the_figures_of_the_report(self):
        row = self.new_row(0)
        self.assertEqual(row["greatest_edge_ratio"], 3.0)
        self.assertEqual(row["resolution"], 1.5)
        self.assertEqual(row["warnings"], ["W-X-1", "W-X-2"])
        failed = self.new_row(1, "why")
        self.assertEqual((failed["blocks"], failed["message"]), (None, "why"))
        self.assertEqual(list(row), list(failed))

    def test_a_shape_is_done_until_its_content_changes_to_an_older_one_too(self):
        self.assertFalse(self.is_done())
        self.finish()
        self.assertTrue(self.is_done())
        os.utime(self.shape)
        self.assertTrue(self.is_done())
        self.shape.write_text("another face")
        os.utime(self.shape, (1, 1))
        self.assertFalse(self.is_done())

    def test_a_shape_is_done_until_a_file_of_the_options_changes(self):
        names = self.here / "names.json"
        names.write_text("[]")
        for words in (["--boundary-names", str(names)], [f"--boundary-names={names}"]):
            results = Results(self.results.folder, "msh", words, "0.1")
            self.finish(results=results)
            self.assertTrue(self.is_done(results))
            names.write_text(names.read_text() + " ")
            self.assertFalse(self.is_done(results))

    def test_it_is_not_done_without_a_file(self):
        for path in (self.results.mesh, self.results.report, self.results.row_file):
            self.finish()
            path(self.shape).unlink()
            self.assertFalse(self.is_done())
        self.finish()
        for foreign in ('{"tool": "ba', "[]", '{"tool": "quadbatch", "shape": 5}'):
            self.results.row_file(self.shape).write_text(foreign)
            self.assertFalse(self.is_done())

    def test_a_failure_is_done_without_a_mesh_unless_it_may_not_repeat(self):
        for exit_code, is_done in ((1, True), (3, True), (70, True), (4, False), (143, False)):
            self.finish(exit_code)
            self.results.mesh(self.shape).unlink()
            self.assertEqual(self.is_done(), is_done)

    def test_other_options_another_version_or_ending_are_another_result(self):
        self.finish()
        for other in (("msh", [], "0.1"), ("xml", ["--size", "1"], "0.1"), ("msh", ["--size", "1"], "0.2")):
            self.assertFalse(self.is_done(Results(self.results.folder, *other)))

    def test_all_rows_by_name(self):
        self.finish()
        self.shape = self.here / "annulus.step"
        self.finish(1)
        (self.results.folder / "other.result.json").write_text("[]")
        self.assertEqual([pathlib.Path(row["shape"]).stem for row in self.results.all_rows()], ["annulus", "disc"])
        self.assertIsNone(read_row(self.results.folder / "none"))


class MessageTest(unittest.TestCase):
    def test_one_line_without_warnings_and_temporary_folders(self):
        text = ("critpoints: warning W-CRIT-001: few\nseparatrix: /t/w/x.h5: no layout\n"
                "quadmesh: the files of the stages before separatrix are kept in /t/w/1; look at the last one with\n"
                "  xdg-open '/t/w/a.svg'\n")
        self.assertEqual(message_of(text, 1, "/t/w"), "separatrix: x.h5: no layout")
        self.assertEqual(message_of("", 143, "/t/w"), "ended by signal 15")
        self.assertEqual((message_of("", 0, "/t/w"), message_of("", 1, "/t/w")), ("", "no message"))


if __name__ == "__main__":
    unittest.main()
