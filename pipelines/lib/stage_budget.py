"""Runs the stages of a pipeline within limits of time and memory: a stage that exceeds them is stopped, with the
processes that it started.

    stage_budget.py open PID SECONDS MEMORY  checks both limits ("": none) and prints the words START SECONDS BYTES;
                                             START is when the process PID began: the pipeline
    stage_budget.py run START SECONDS BYTES all|most LEDGER REPORT TOOL ARGUMENT...
    stage_budget.py killed REPORT TOOL       writes the report of a stage that the system killed

The stage may use all seconds, or most: then some are kept for quads that are made from the triangles alone. The file
LEDGER has a line for each run: its CPU seconds and its elapsed seconds. The first run is that of the triangles. A stage
that is stopped gets a report, with the reason, and the exit code STOPPED.

Both the CPU seconds of all runs, threads and child processes included, and the seconds since START are limited. The
memory is what is resident or swapped out, not what is reserved: CAD kernels and threads reserve far more than they use.
"""
import math
import os
import signal
import sys
import time

STOPPED = 124  # no tool has this exit code
INTERVAL = 0.02  # seconds between two looks at the processes
GRACE = 1  # seconds in which a stopped process can remove its temporary files
# What is kept: this share of the seconds, and this many times those of the triangles. Quads from triangles took 2.6 to 4
# times as long as the triangles, on real faces and on plates with up to 144 holes.
KEPT_SHARE = 0.25
KEPT_TIMES = 5
WATCHED = (signal.SIGCHLD, signal.SIGTERM, signal.SIGINT, signal.SIGHUP)
UNITS = {"K": 1 << 10, "M": 1 << 20, "G": 1 << 30, "T": 1 << 40}


class Mistake(Exception):
    """A limit that cannot be understood."""


def amount(option, text, unit=1):
    try:
        value = float(text)
    except ValueError:
        raise Mistake(f"{option}: '{text}' is not {'a size' if option == '--max-memory' else 'a number'}") from None
    if not 0 < value < math.inf:
        raise Mistake(f"{option}: {text} is outside its interval (above 0)")
    return value * unit


def seconds_of(text):
    return amount("--max-seconds", text)


def bytes_of(text):
    unit = UNITS.get(text[-1:].upper())
    return int(amount("--max-memory", text[:-1] if unit else text, unit or 1))


def size_text(size):
    """A number of bytes in the unit in which it has at most four digits."""
    unit = next((unit for unit in UNITS if size < 10000 * UNITS[unit]), "T")
    return f"{size / UNITS[unit]:.0f}{unit}"


def status_words(pid):
    """/proc/PID/stat behind the name: state, parent, ..., or None if the process has ended."""
    try:
        with open(f"/proc/{pid}/stat", "rb") as file:
            return file.read().rpartition(b")")[2].split()
    except OSError:
        return None


def start_of(pid):
    """The value of time.monotonic() when a process began."""
    since_boot = int(status_words(pid)[19]) / os.sysconf("SC_CLK_TCK")
    return time.monotonic() - (time.clock_gettime(time.CLOCK_BOOTTIME) - since_boot)


class ProcessTree:
    """A process and those that descend from it. Only processes that were not seen before are looked at."""

    def __init__(self, root):
        self.members = {root}
        self._others = set()

    def update(self):
        present = {int(name) for name in os.listdir("/proc") if name.isdigit()}
        self.members &= present
        self._others &= present
        fresh = {pid: status_words(pid) for pid in present - self.members - self._others}
        while found := {pid for pid, words in fresh.items() if words and int(words[1]) in self.members}:
            self.members |= found
            fresh = {pid: words for pid, words in fresh.items() if pid not in found}
        self._others |= set(fresh)

    def cpu_seconds(self):
        """Of all members, with the children for which they have waited."""
        ticks = sum(int(word) for pid in self.members for word in (status_words(pid) or [b"0"] * 15)[11:15])
        return ticks / os.sysconf("SC_CLK_TCK")

    def memory(self):
        """Bytes that are resident or swapped out."""
        total = 0
        for pid in self.members:
            try:
                with open(f"/proc/{pid}/status", "rb") as file:
                    total += sum(int(line.split()[1]) for line in file if line.startswith((b"VmRSS:", b"VmSwap:")))
            except OSError:
                pass
        return total << 10

    def kill(self, signum):
        for pid in self.members:
            try:
                os.kill(pid, signum)
            except ProcessLookupError:
                pass


class Budget:
    """The limits of one stage. `seconds` and `memory` are None without a limit. `runs` are those before: pairs of CPU
    seconds and elapsed seconds."""

    def __init__(self, start, seconds, memory, may_use="all", runs=()):
        self.start, self.seconds, self.memory, self.may_use = start, seconds, memory, may_use
        self.spent = sum(cpu for cpu, _ in runs)
        self.triangles = runs[0] if runs else (0.0, 0.0)

    def limits(self):
        """Of the CPU seconds of all runs and of the seconds from the start."""
        if self.may_use == "all":
            return self.seconds, self.seconds
        return [self.seconds - max(KEPT_SHARE * self.seconds, KEPT_TIMES * taken) for taken in self.triangles]

    def reason_to_stop(self, tree=None):
        """None, or the reason, which follows "TOOL was". Without a tree: before the start."""
        if self.seconds is not None:
            cpu = self.spent + (tree.cpu_seconds() if tree else 0)
            elapsed = time.monotonic() - self.start
            most_cpu, most_elapsed = self.limits()
            if cpu > most_cpu or elapsed > most_elapsed:
                used = f"{cpu:.2f} s of CPU time" if cpu > most_cpu else f"{elapsed:.2f} s"
                return self._time_text(used, "stopped" if tree else "not started")
        if self.memory is not None and tree and (size := tree.memory()) > self.memory:
            return f"stopped at {size_text(size)} of memory: --max-memory is {size_text(self.memory)}"
        return None

    def _time_text(self, used, what):
        kept = ", and the rest is kept for quads without a field" if self.may_use == "most" else ""
        return f"{what} after {used} of all stages: --max-seconds is {self.seconds:g}{kept}"


def start(words, mask):
    """The process of a command, which gets the signals as this process had them: with this mask."""
    pid = os.fork()
    if pid:
        return pid
    try:
        for signum in (signal.SIGPIPE, signal.SIGXFSZ):  # which the interpreter ignores
            signal.signal(signum, signal.SIG_DFL)
        signal.pthread_sigmask(signal.SIG_SETMASK, mask)
        os.execvp(words[0], words)
    except OSError as error:
        print(f"{words[0]} cannot be started: {error.strerror}", file=sys.stderr)
    finally:
        os._exit(127)


def end(tree, pid):
    """Ends all processes of the tree; those that need longer than GRACE cannot clean up. Returns the CPU seconds that they
    have used, also those for which their parents no longer wait."""
    tree.update()
    cpu = tree.cpu_seconds()
    tree.kill(signal.SIGTERM)
    deadline = time.monotonic() + GRACE
    while time.monotonic() < deadline:
        ended, _, usage = os.wait4(pid, os.WNOHANG)
        if ended:
            tree.members.discard(pid)
            break
        signal.sigtimedwait(WATCHED, INTERVAL)
    tree.update()
    tree.kill(signal.SIGKILL)
    if not ended:
        usage = os.wait4(pid, 0)[2]
    return max(cpu, usage.ru_utime + usage.ru_stime)


def run_within(budget, words):
    """Runs a command. Returns its exit code, 128 + n if signal n ended it, its CPU seconds, and None or the reason for
    which it was stopped."""
    reason = budget.reason_to_stop()
    if reason:
        return STOPPED, 0.0, reason
    mask = signal.pthread_sigmask(signal.SIG_BLOCK, WATCHED)
    try:
        pid = start(words, mask)
        return watch(pid, budget)
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, mask)


def watch(pid, budget):
    """Until the process ends, or has to; what run_within returns."""
    tree = ProcessTree(pid)
    while True:
        arrived = signal.sigtimedwait(WATCHED, INTERVAL)
        ended, status, usage = os.wait4(pid, os.WNOHANG)
        if ended:
            code = os.waitstatus_to_exitcode(status)
            return code if code >= 0 else 128 - code, usage.ru_utime + usage.ru_stime, None
        if arrived and arrived.si_signo != signal.SIGCHLD:
            return 128 + arrived.si_signo, end(tree, pid), None
        tree.update()
        reason = budget.reason_to_stop(tree)
        if reason:
            return STOPPED, end(tree, pid), reason


def write_report(path, tool, reason, cpu=0.0, elapsed=0.0):
    """The report of a stage that could not write its own; its warning holds if there are quads without a field."""
    import json  # takes longer than all else here, and is rarely needed

    warning = {"tool": "quadmesh", "code": "W-RUN-001",
               "message": f"{tool} was {reason}: the quads are made without a field"}
    report = {"tool": tool, "exit_code": 1, "error": reason,
              "timings": {"total": {"cpu_seconds": cpu, "wall_seconds": elapsed}}, "warnings": [warning]}
    with open(path, "w", encoding="utf-8") as file:
        json.dump(report, file)


def runs_in(ledger):
    try:
        with open(ledger, encoding="ascii") as file:
            return [tuple(map(float, line.split())) for line in file]
    except FileNotFoundError:
        return []


def run(start_text, seconds, memory, may_use, ledger, report, *words):
    budget = Budget(float(start_text), None if seconds == "-" else float(seconds), None if memory == "-" else int(memory),
                    may_use, runs_in(ledger))
    before = time.monotonic()
    code, cpu, reason = run_within(budget, words)
    elapsed = time.monotonic() - before
    with open(ledger, "a", encoding="ascii") as file:
        file.write(f"{cpu:.6f} {elapsed:.6f}\n")
    if reason:
        write_report(report, words[0], reason, cpu, elapsed)
    return code


def main(action, *words):
    if action == "open":
        pid, seconds, memory = words
        try:
            print(start_of(pid), repr(seconds_of(seconds)) if seconds else "-", bytes_of(memory) if memory else "-")
        except Mistake as mistake:
            print(mistake)
            return 2
        return 0
    if action == "killed":
        write_report(*words, "killed by signal 9, as systems do when memory runs out")
        return 0
    return run(*words)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
