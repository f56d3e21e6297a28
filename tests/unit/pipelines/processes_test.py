import os
import threading
import time
import unittest

from bench.processes import Overtaken, Processes
from command_frame import Failure


class ProcessesTest(unittest.TestCase):
    def setUp(self):
        self.processes = Processes(os.environ | {"WHAT": "seen"})

    def test_output_messages_and_codes(self):
        self.processes.begin(1)
        run = self.processes.of(1)
        self.assertEqual(run.output_of(["sh", "-c", "echo $WHAT"]), "seen\n")
        self.assertEqual(run.run(["sh", "-c", "echo so; echo no >&2; exit 3"]), (3, "so\n", "no\n"))
        with self.assertRaises(Failure) as failure:
            run.output_of(["sh", "-c", "echo 'sh: no' >&2; exit 3"])
        self.assertEqual((failure.exception.code, str(failure.exception)), (3, "no"))

    def test_a_newer_run_stops_an_older_one(self):
        self.processes.begin(1)
        ends = []

        def older():
            try:
                self.processes.of(1).run(["sleep", "60"])
            except Overtaken:
                ends.append(time.monotonic())

        thread = threading.Thread(target=older)
        thread.start()
        while self.processes.running is None:
            time.sleep(0.01)
        self.processes.begin(2)
        thread.join(10)
        self.assertEqual(len(ends), 1)
        self.assertEqual(self.processes.of(2).run(["true"])[0], 0)

    def test_an_older_or_equal_number_and_all_after_the_end_are_refused(self):
        self.processes.begin(5)
        for number in (4, 5):
            with self.assertRaises(Overtaken):
                self.processes.begin(number)
        with self.assertRaises(Overtaken):
            self.processes.of(4).run(["true"])
        self.processes.close()
        with self.assertRaises(Overtaken):
            self.processes.of(5).run(["true"])
        with self.assertRaises(Overtaken):
            self.processes.begin(6)
