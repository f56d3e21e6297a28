"""Runs the tools: files go in and out in memory, messages become exceptions and warnings, and no process is left."""
import contextlib
import dataclasses
import json
import os
import signal
import subprocess
import warnings

from .memory_files import MemoryFiles, file_name
from .tool_errors import ToolError, ToolWarning, tool_path
from .tool_words import option_words


@dataclasses.dataclass
class Outcome:
    """Of a run: what the tool wrote to standard output, its report, and its messages on standard error."""
    data: bytes
    report: dict
    messages: str


def run(tool, inputs, options, fixed=(), without=(), output="-", level=2):
    """Runs a tool and returns its Outcome. `inputs`: paths, bytes or results of stages; `options`: by keyword, the
    tool's own (tool_words); `fixed`: words beside them; `without`: options of the
    tool that the caller does not offer; `output`: the value of -o. Warnings are issued at the place `level` calls above
    this one. Raises ToolError."""
    with MemoryFiles() as files:
        words = option_words(tool, options, files, without)
        names = [file_name(source, files) for source in inputs]
        out, errors, report = files.new(), files.new(), files.new()
        command = [tool_path(tool), *fixed, *words, "--report", f"/proc/self/fd/{report}", "-o", os.fspath(output), *names]
        code = wait_for(command, out, errors, files.descriptors)
        messages = files.labelled(files.content(errors).decode(errors="replace"))
        written = files.labelled(files.content(report).decode(errors="replace"))
        outcome = Outcome(files.content(out), json.loads(written) if written else {}, messages)
    for warning in outcome.report.get("warnings") or []:
        issued = ToolWarning(warning.get("tool", tool), warning["code"], warning["message"])
        warnings.warn(issued, stacklevel=level + 1)
    if code != 0:
        raise error_of(tool, code, outcome)
    return outcome


def wait_for(command, out, errors, descriptors):
    """The exit code, 128 + n for signal n. Whatever interrupts the wait ends the process and all that it started."""
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=errors, pass_fds=descriptors,
                               process_group=0)
    try:
        code = process.wait()
    except BaseException:
        stop(process)
        raise
    return 128 - code if code < 0 else code


def stop(process, seconds=5):
    """By TERM, at which tools remove their temporary files, and by KILL what remains."""
    for signum in (signal.SIGTERM, signal.SIGKILL):
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signum)
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(seconds)


def error_of(tool, code, outcome):
    stage = outcome.report.get("stage") or tool
    text = outcome.report.get("error") or ""
    if not text:
        lines = [line for line in outcome.messages.splitlines() if ": warning W-" not in line]
        text = lines[0].partition(": ")[2] if lines else ""
    if not text:
        text = f"ended by signal {code - 128}" if code > 128 else f"exit code {code}"
    return ToolError(code, stage, text, outcome.report or None)
