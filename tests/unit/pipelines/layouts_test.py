import unittest

from command_frame import Failure
from node_search.layouts import run_stage


class RunStageTest(unittest.TestCase):
    def test_the_exit_code_of_a_stage_is_that_of_the_failure(self):
        run_stage("true")
        for words, code in ((["sh", "-c", "exit 3"], 3), (["sh", "-c", "kill -TERM $$"], 143)):
            with self.assertRaises(Failure) as raised:
                run_stage(*words, is_trial=True)
            self.assertEqual((raised.exception.code, str(raised.exception)), (code, ""))
