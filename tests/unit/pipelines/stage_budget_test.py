import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from unittest import mock

import stage_budget
from stage_budget import Budget, Mistake, ProcessTree

PROGRAM = [sys.executable, "-ISB", stage_budget.__file__]
BUSY = "while True: pass"
HEAP = "import time; data = bytearray(b'x' * (200 << 20)); time.sleep(60)"
CHILD = "import subprocess, sys; subprocess.run([sys.executable, '-c', sys.argv[1]])"  # runs this text in a child


def python(text, *words):
    return [sys.executable, "-c", text, *words]


class LimitsTest(unittest.TestCase):
    def test_sizes_and_seconds(self):
        for text, size in (("1000", 1000), ("2G", 2 << 30), ("500m", 500 << 20), ("1.5K", 1536), ("1T", 1 << 40)):
            self.assertEqual(stage_budget.bytes_of(text), size)
        self.assertEqual(stage_budget.seconds_of("1e-1"), 0.1)
        for text in ("", "G", "2GB", "0", "-1M", "inf", "nan", "none"):
            self.assertRaises(Mistake, stage_budget.bytes_of, text)
            self.assertRaises(Mistake, stage_budget.seconds_of, text)

    def test_sizes_are_printed_with_at_most_four_digits(self):
        self.assertEqual([stage_budget.size_text(n) for n in (2048, 9999 << 10, 10000 << 10, 500 << 20, 3 << 40)],
                         ["2K", "9999K", "10M", "500M", "3072G"])

    def test_the_program_prints_what_it_is_run_with(self):
        before = time.monotonic()
        began = subprocess.Popen(["sleep", "3600"])
        try:
            run = subprocess.run([*PROGRAM, "open", str(began.pid), "10", "1K"], capture_output=True, text=True)
        finally:
            began.kill()
            began.wait()
        start, seconds, memory = run.stdout.split()
        self.assertGreater(float(start), before - 0.1)  # a process has the clock tick in which it began
        self.assertLess(float(start), time.monotonic())
        self.assertEqual((run.returncode, seconds, memory), (0, "10.0", "1024"))
        run = subprocess.run([*PROGRAM, "open", str(os.getpid()), "", "1"], capture_output=True, text=True)
        self.assertEqual(run.stdout.split()[1:], ["-", "1"])
        run = subprocess.run([*PROGRAM, "open", str(os.getpid()), "x", ""], capture_output=True, text=True)
        self.assertEqual((run.returncode, run.stdout), (2, "--max-seconds: 'x' is not a number\n"))


class RunTest(unittest.TestCase):
    def run_within(self, words, seconds=None, memory=None, **others):
        return stage_budget.run_within(Budget(time.monotonic(), seconds, memory, **others), words)

    def test_a_command_within_its_limits_keeps_its_exit_code(self):
        for text, code in (("", 0), ("exit(3)", 3), ("import os, signal; os.kill(os.getpid(), 9)", 137),
                           ("import os; os.abort()", 134)):
            found, cpu, reason = self.run_within(python(text), 600, 1 << 40)
            self.assertEqual((found, reason), (code, None))
            self.assertGreater(cpu, 0)

    def test_signals_reach_the_command_as_without_the_program(self):
        words = ["grep", "-E", "^Sig(Blk|Ign):", "/proc/self/status"]
        bare = subprocess.run(words, capture_output=True, text=True).stdout
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([*PROGRAM, "run", "0", "-", "-", "all", f"{folder}/l", f"{folder}/r", *words],
                                 capture_output=True, text=True)
        self.assertEqual((run.returncode, run.stdout), (0, bare))

    def test_work_is_stopped_when_the_cpu_seconds_are_used_up_in_a_child_too(self):
        for words in (python(BUSY), python(CHILD, BUSY)):
            in_an_hour = time.monotonic() + 3600  # so that only CPU seconds count
            code, cpu, reason = stage_budget.run_within(Budget(in_an_hour, 1, None, runs=[(0.6, 0)]), words)
            self.assertEqual(code, stage_budget.STOPPED)
            self.assertGreater(cpu, 0.3)
            self.assertRegex(reason, r"^stopped after \d\.\d\d s of CPU time of all stages: --max-seconds is 1$")

    def test_waiting_is_stopped_when_the_seconds_have_elapsed(self):
        code, _, reason = self.run_within(["sleep", "60"], 0.2)
        self.assertEqual(code, stage_budget.STOPPED)
        self.assertRegex(reason, r"^stopped after \d+\.\d\d s of all stages: --max-seconds is 0\.2$")

    def test_a_quarter_of_the_seconds_is_kept_and_more_if_the_triangles_took_long(self):
        self.assertEqual(Budget(0, 8, None, runs=[(1, 3), (2, 4)]).limits(), (8, 8))
        self.assertEqual(Budget(0, 8, None, "most", [(0.1, 0.2), (2, 4)]).limits(), [6, 6])
        self.assertEqual(Budget(0, 8, None, "most", [(1, 1.5), (2, 4)]).limits(), [3, 0.5])
        code, _, reason = self.run_within(["sleep", "60"], 1, may_use="most")
        self.assertEqual(code, stage_budget.STOPPED)
        self.assertRegex(reason, r"^stopped after \d+\.\d\d s .*is 1, and the rest is kept for quads without a field$")

    def test_nothing_is_started_when_the_seconds_are_used_up(self):
        with tempfile.TemporaryDirectory() as folder:
            code, cpu, reason = self.run_within(["touch", f"{folder}/started"], 1, runs=[(1, 0), (0.5, 0)])
            self.assertEqual((code, cpu, os.listdir(folder)), (stage_budget.STOPPED, 0, []))
        self.assertEqual(reason, "not started after 1.50 s of CPU time of all stages: --max-seconds is 1")

    def test_a_command_that_has_more_memory_is_stopped_in_a_child_too(self):
        for words in (python(HEAP), python(CHILD, HEAP)):
            code, _, reason = self.run_within(words, memory=100 << 20)
            self.assertEqual(code, stage_budget.STOPPED)
            self.assertRegex(reason, r"^stopped at \d+M of memory: --max-memory is 100M$")

    def test_memory_that_is_only_reserved_does_not_count(self):
        text = "import mmap, time; data = mmap.mmap(-1, 4 << 30, flags=mmap.MAP_PRIVATE); time.sleep(0.1)"
        self.assertEqual(self.run_within(python(text), memory=100 << 20)[0], 0)

    def stop_when_exists(self, path, script, grace):
        """Runs a shell script and stops it when this file exists."""
        budget = Budget(time.monotonic(), None, None)
        budget.reason_to_stop = lambda tree=None: "stopped" if path.exists() else None
        with mock.patch.object(stage_budget, "GRACE", grace):
            self.assertEqual(stage_budget.run_within(budget, ["sh", "-c", script])[0], stage_budget.STOPPED)

    def test_a_stopped_command_can_clean_up_and_one_that_does_not_end_is_killed(self):
        with tempfile.TemporaryDirectory() as folder:
            part, started = pathlib.Path(folder, "part"), pathlib.Path(folder, "started")
            wait = "while :; do sleep 0.01; done"
            self.stop_when_exists(part, f"trap 'rm {part}; exit 1' TERM; touch {part}; {wait}", 60)
            self.assertFalse(part.exists())
            self.stop_when_exists(started, f"trap '' TERM; touch {started}; {wait}", 0.1)

    def test_nothing_that_a_stopped_command_started_goes_on(self):
        with tempfile.TemporaryDirectory() as folder:
            ids, started = pathlib.Path(folder, "ids"), pathlib.Path(folder, "started")
            script = f"(trap '' TERM; sleep 3600) & echo $! >{ids}; touch {started}; wait"
            self.stop_when_exists(started, script, 0.1)
            pid = int(ids.read_text())
            deadline = time.monotonic() + 60
            while (stage_budget.status_words(pid) or [b"Z"])[0] != b"Z":  # a zombie has ended
                self.assertLess(time.monotonic(), deadline)

    def test_a_signal_ends_the_command_too(self):
        with tempfile.TemporaryDirectory() as folder:
            started = pathlib.Path(folder, "started")
            script = f"trap 'rm {started}; exit 1' TERM; touch {started}; while :; do sleep 0.01; done"
            files = f"{folder}/ledger", f"{folder}/report"
            run = subprocess.Popen([*PROGRAM, "run", "0", "-", "-", "all", *files, "sh", "-c", script])
            while not started.exists():
                time.sleep(0.01)
            run.send_signal(signal.SIGTERM)
            self.assertEqual(run.wait(), 143)
            self.assertFalse(started.exists())


class ProgramTest(unittest.TestCase):
    def test_seconds_add_up_and_a_stopped_command_gets_a_report(self):
        work = python("sum(range(10**7))")
        with tempfile.TemporaryDirectory() as folder:
            ledger, report = f"{folder}/ledger", pathlib.Path(folder, "report.json")
            words = [*PROGRAM, "run", str(time.monotonic()), "1e6", "-", "all", ledger, report]
            self.assertEqual([subprocess.run([*words, *work]).returncode for _ in range(2)], [0, 0])
            (first, first_elapsed), (second, second_elapsed) = stage_budget.runs_in(ledger)
            self.assertGreater(min(first, first_elapsed, second, second_elapsed), 0)
            self.assertFalse(report.exists())
            words[words.index("1e6")] = str((first + second) / 2)
            self.assertEqual(subprocess.run([*words, *work]).returncode, stage_budget.STOPPED)
            written = json.loads(report.read_text())
        self.assertEqual((written["tool"], written["exit_code"]), (sys.executable, 1))
        self.assertRegex(written["error"], "^not started after ")
        self.assertEqual(written["timings"]["total"]["cpu_seconds"], 0)
        self.assertEqual([(w["tool"], w["code"]) for w in written["warnings"]], [("quadmesh", "W-RUN-001")])


class ProcessTreeTest(unittest.TestCase):
    def test_descendants_are_found_also_if_others_were_looked_at_before(self):
        script = "sleep 60 & sh -c 'sleep 60 & wait' & wait"
        run = subprocess.Popen(["sh", "-c", script], start_new_session=True)
        try:
            tree = ProcessTree(run.pid)
            while len(tree.members) < 4:
                tree.update()
            self.assertNotIn(os.getpid(), tree.members)
            self.assertGreater(tree.memory(), 0)
        finally:
            os.killpg(run.pid, signal.SIGKILL)
            run.wait()
        tree.members.discard(run.pid)
        tree.update()
        self.assertNotIn(run.pid, tree.members)


if __name__ == "__main__":
    unittest.main()
