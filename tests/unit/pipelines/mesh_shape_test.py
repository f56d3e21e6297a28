import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from many_shapes import mesh_shape

GOOD = """#!/bin/sh
while [ $# -gt 0 ]; do
  case $1 in -o) out=$2 ;; --report) report=$2 ;; esac
  shift
done
echo mesh >"$out"; echo names >"${out%.msh}.names.json"; : >"$TMPDIR/left"
echo '{"blocks": 1, "quads": 2, "warnings": []}' >"$report"
"""
BAD = "#!/bin/sh\necho \"separatrix: $TMPDIR/x.sep.json: no layout\" >&2\nexit 1\n"
SLOW = "#!/bin/sh\ntrap 'kill $!; exit 143' TERM\nsleep 60 &\n: >\"$TMPDIR/started\"\nwait $!\n"


def wait_until(is_true, seconds=20):
    deadline = time.monotonic() + seconds
    while not is_true() and time.monotonic() < deadline:
        time.sleep(0.01)
    assert is_true(), "it did not come to this"


class MeshShapeTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.here = pathlib.Path(folder.name)
        self.out = self.here / "out"
        self.out.mkdir()

    def job(self, quadmesh):
        program = self.here / "quadmesh"
        program.write_text(quadmesh)
        program.chmod(0o755)
        return {"shape": "a.step", "folder": str(self.out), "ending": "msh", "version": "1", "options": [],
                "threads": "1", "verbose": True, "quadmesh": str(program)}

    def files(self):
        return sorted(os.listdir(self.out))

    def test_mesh_report_row_and_what_the_format_has_beside(self):
        row = mesh_shape.mesh_shape(self.job(GOOD))
        self.assertEqual((row["exit_code"], row["quads"], row["message"]), (0, 2, ""))
        self.assertEqual(self.files(), ["a.msh", "a.names.json", "a.report.json", "a.result.json"])
        self.assertEqual(json.loads((self.out / "a.result.json").read_text()), row)

    def test_a_failure_replaces_an_old_mesh_by_its_message(self):
        mesh_shape.mesh_shape(self.job(GOOD))
        (self.out / "a.names.json").unlink()
        row = mesh_shape.mesh_shape(self.job(BAD))
        self.assertEqual((row["exit_code"], row["quads"]), (1, None))
        self.assertEqual(row["message"], "separatrix: x.sep.json: no layout")
        self.assertEqual(self.files(), ["a.result.json"])

    def test_a_shape_waits_for_another_job_with_it_and_is_not_meshed_again(self):
        shape = self.here / "a.step"
        shape.touch()
        os.utime(shape, (1, 1))
        count = f"echo x >>'{self.here}/runs'; until [ -e '{self.here}/go' ]; do sleep 0.01; done\n"
        job = json.dumps(self.job(GOOD + count) | {"shape": str(shape)})
        jobs = [subprocess.Popen([sys.executable, "-B", mesh_shape.__file__, job], stdout=subprocess.DEVNULL)
                for _ in range(3)]
        locked = f":{shape.stat().st_ino} "
        wait_until(lambda: sum("->" in line and locked in line
                               for line in pathlib.Path("/proc/locks").read_text().splitlines()) == 2)
        (self.here / "go").touch()
        self.assertEqual([process.wait(20) for process in jobs], [0, 0, 0])
        self.assertEqual((self.here / "runs").read_text(), "x\n")
        self.assertEqual(self.files(), ["a.msh", "a.names.json", "a.report.json", "a.result.json"])

    def test_a_signal_ends_the_shape_and_leaves_nothing(self):
        process = subprocess.Popen([sys.executable, "-B", mesh_shape.__file__, json.dumps(self.job(SLOW))])
        wait_until((self.out / ".a.part" / "started").exists)
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(20), -signal.SIGTERM)
        self.assertEqual(self.files(), [])


if __name__ == "__main__":
    unittest.main()
