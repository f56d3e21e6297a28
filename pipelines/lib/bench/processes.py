"""Commands of the newest run only: when a newer one begins, the command of an older one is stopped."""
import subprocess
import threading

import command_frame as frame


class Overtaken(Exception):
    """A newer run has begun, or the workbench was closed."""


class Processes:
    """Runs commands of the newest number only: begin(number) stops the command of an older one."""

    def __init__(self, environment):
        self.environment, self.lock, self.newest, self.running = environment, threading.Lock(), -1, None

    def begin(self, number):
        with self.lock:
            if number <= self.newest:
                raise Overtaken
            self.newest = number
            if self.running is not None:
                self.running.terminate()

    def close(self):
        self.begin(float("inf"))

    def require_newest(self, number):
        if number != self.newest:
            raise Overtaken

    def of(self, number):
        return NumberedRun(self, number)


class NumberedRun:
    """The commands of one run."""

    def __init__(self, processes, number):
        self.processes, self.number = processes, number

    def run(self, words):
        """The exit code, what the command prints, and its messages."""
        processes = self.processes
        with processes.lock:
            processes.require_newest(self.number)
            process = processes.running = subprocess.Popen(
                [str(word) for word in words], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                encoding="utf-8", errors="replace", env=processes.environment)
        try:
            printed, messages = process.communicate()
        except frame.Stopped:
            process.terminate()
            process.wait()
            raise
        with processes.lock:
            processes.running = None
            processes.require_newest(self.number)
        return process.returncode, printed, messages

    def output_of(self, words):
        """What a command prints; a Failure with its message if it fails."""
        code, printed, messages = self.run(words)
        if code:
            raise frame.Failure(code, messages.partition("\n")[0].removeprefix(f"{words[0]}: "))
        return printed
