"""What the Python commands share: options, exit codes, signals, and files that are written whole or not at all."""
import contextlib
import errno
import functools
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile

from nearest_word import nearest_word

SHORT = {"-o": "--output", "-v": "--verbose", "-q": "--quiet", "-h": "--help"}
NO_RESULT, USAGE, BAD_INPUT, NOT_WRITTEN, INTERNAL = 1, 2, 3, 4, 70  # exit codes


class Failure(Exception):
    """Ends the command with an exit code. Without a message: a stage has printed it."""

    def __init__(self, code, message=""):
        super().__init__(message)
        self.code = code


class Stopped(BaseException):
    """A signal arrived; its number is the argument."""


def mistake(message):
    return Failure(USAGE, message)


def is_answered(command, words, help_text):
    """Prints help_text() or the version if a word asks for it, wherever that stands: no other word is then read, so
    that none is refused. The rule is that of lib/program/cli/outcome."""
    for word in words:
        if word in ("--help", "--help-all") or re.fullmatch("-[vq]*h[vqh]*", word):
            print(help_text(), end="")
            return True
        if word == "--version":
            print(version_text(command), end="")
            return True
    return False


def option_pairs(words, kind_of, names=tuple):
    """Splits a command line: yields (option, value), (flag, None), and (None, word) for a word that is no option.
    `kind_of(option)` is "value", "flag" or None for an unknown option; the name is the long one. `names()` are those
    of all options, for the nearest one to an unknown one."""
    words = list(words)
    while words:
        word, *words = _separated(words.pop(0)) + words
        has_value = word.startswith("--") and "=" in word
        if has_value:
            word, value = word.split("=", 1)
            words.insert(0, value)
        word = SHORT.get(word, word)
        if not word.startswith("-") or word == "-":
            yield None, word
            continue
        kind = kind_of(word)
        if kind is None:
            nearest = nearest_word(word, list(names()))
            raise mistake(f"unknown option {word}" + (f": did you mean {nearest}?" if nearest else ""))
        if kind == "flag" and has_value:
            raise mistake(f"{word} takes no value")
        if kind == "value" and not words:
            raise mistake(f"{word} needs a value")
        if kind == "value" and not has_value and len(words[0]) > 2 and words[0].startswith("--"):
            raise mistake(f"{word} needs a value, not the option {words[0]}")
        yield word, words.pop(0) if kind == "value" else None


def _separated(word):
    """-qv as -q -v, -oFILE as -o FILE."""
    if len(word) < 3 or word[0] != "-" or word[1] == "-" or word[:2] not in SHORT:
        return [word]
    return ["-o", word[2:]] if word[1] == "o" else [word[:2], "-" + word[2:]]


def number(option, text, low, high, kind=float, is_open=False):
    """The value of a numeric option, between `low` (excluded if `is_open`) and `high`."""
    try:
        value = kind(text)
    except ValueError:
        raise mistake(f"{option}: '{text}' is not {'an integer' if kind is int else 'a number'}") from None
    if not (low < value if is_open else low <= value) or not value <= high:
        raise mistake(f"{option}: {text} is outside its interval ({_interval(low, high, is_open)})")
    return value


def _interval(low, high, is_open):
    """In words, as the tools write it."""
    if high < sys.float_info.max:
        return f"above {low:g}, at most {high:g}" if is_open else f"{low:g} to {high:g}"
    return f"above {low:g}" if is_open else f"at least {low:g}"


def add_tools_to_path(script):
    """Puts the folder of the tools first on PATH: $QUADRILLE_BIN, the build beside the sources, or the script's own."""
    here = pathlib.Path(script).resolve().parent
    for folder in (os.environ.get("QUADRILLE_BIN"), here.parent / "build" / "bin", here):
        if folder and os.access(pathlib.Path(folder) / "cad2tri", os.X_OK):
            os.environ["PATH"] = f"{pathlib.Path(folder).resolve()}{os.pathsep}{os.environ.get('PATH', '')}"
            return


def require_tools():
    if not shutil.which("cad2tri"):
        raise Failure(1, "no cad2tri on PATH; pipelines/quickstart builds it")


def require_input(path):
    """That the file exists, can be read and is not empty; - is standard input."""
    if path == "-":
        return
    if not os.path.exists(path):
        raise Failure(BAD_INPUT, f"{path}: no such file")
    if os.path.isdir(path):
        raise Failure(BAD_INPUT, f"{path}: is a directory, not a file")
    if not os.access(path, os.R_OK):
        raise Failure(BAD_INPUT, f"{path}: cannot be read: permission denied")
    if os.path.isfile(path) and not os.path.getsize(path):
        raise Failure(BAD_INPUT, f"{path}: is empty")


def read_bytes(path):
    """What the file holds, or standard input for -."""
    if path == "-" and sys.stdin.isatty():
        raise Failure(BAD_INPUT, "standard input is a terminal; name a file")
    try:
        return sys.stdin.buffer.read() if path == "-" else pathlib.Path(path).read_bytes()
    except OSError as error:
        raise Failure(BAD_INPUT, f"{path}: cannot be read: {error.strerror}") from None


def require_outputs(outputs, inputs):
    """That the outputs can be written, and are neither inputs nor each other, by whatever name."""
    named = [path for path in outputs if path and path != "-"]
    for k, path in enumerate(named):
        if os.path.isdir(path):
            raise Failure(NOT_WRITTEN, f"{path}: cannot be written: is a directory")
        folder = os.path.dirname(path) or "."
        if not os.path.isdir(folder):
            raise Failure(NOT_WRITTEN, f"{path}: cannot be written: there is no folder {folder}")
        if any(_is_same_file(path, other) for other in inputs if other and other != "-"):
            raise mistake(f"the output {path} is an input")
        if any(_is_same_file(path, other) for other in named[:k]):
            raise mistake(f"two outputs are the same file: {path}")


def _is_same_file(path, other):
    if not (os.path.exists(path) and os.path.exists(other)):
        return os.path.realpath(path) == os.path.realpath(other)
    return os.path.isfile(path) and os.path.samefile(path, other)


def check_options(tool, *words):
    """That these are arguments of the tool; a mistake is one of this command, and so is 1, a shape that would need far
    too many quads. The words let the tool end before it works (--dry-run)."""
    tried = subprocess.run([tool, *words], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
    if tried.returncode in (1, USAGE):
        raise Failure(tried.returncode, tried.stderr.splitlines()[0].removeprefix(f"{tool}: "))


def counted(count, noun):
    return f"{count} {noun}{'s' * (count != 1)}"


def output_of(*words):
    return subprocess.run(words, capture_output=True, text=True, check=True).stdout


def version_text(command):
    """The version of the tools, which is that of all commands."""
    require_tools()
    return output_of("quadexport", "--version").replace("quadexport", command)


@functools.cache
def option_kinds(tool):
    """What follows each option of a tool: "value", "values" (may be given several times), "file" or, nothing, "flag"."""
    require_tools()
    return dict(line.split()[1:] for line in output_of(tool, "--list-options").splitlines())


def listed_options(tool):
    """The options of a tool: "value" or "flag" for each."""
    return {option: "flag" if kind == "flag" else "value" for option, kind in option_kinds(tool).items()}


def options_help(tool):
    """The options of a tool as its --help describes them, without --output; empty without the tool."""
    if not shutil.which(tool):
        return ""
    rows = re.split(r"\n(?=  -)", re.search(r"\nOPTIONS(\n.*?)\n\n", output_of(tool, "--help"), re.DOTALL)[1])
    return f"\nOPTIONS OF {tool.upper()}" + "".join(f"\n{row}" for row in rows[1:] if not row.startswith("  -o,")) + "\n"


_part = None  # the file that is being written


def write_file(path, content):
    """Writes UTF-8 text to a file, all or nothing; to standard output for -; straight into a pipe or a device."""
    try:
        if path == "-":
            sys.stdout.write(content)
            sys.stdout.flush()
        elif os.path.exists(path) and not os.path.isfile(path):
            pathlib.Path(path).write_text(content, encoding="utf-8")
        else:
            _replace(path, content)
    except OSError as error:
        _remove_part()
        name = "standard output" if path == "-" else path
        raise Failure(NOT_WRITTEN, f"{name}: cannot be written: {error.strerror}") from None


def _replace(path, content):
    """A symbolic link keeps its place, a file its mode."""
    global _part
    target = pathlib.Path(os.path.realpath(path))
    handle, name = tempfile.mkstemp(prefix=".", suffix=".tmp", dir=target.parent)
    _part = pathlib.Path(name)
    with open(handle, "w", encoding="utf-8") as part:
        part.write(content)
        part.flush()
        os.fchmod(handle, target.stat().st_mode & 0o7777 if target.exists() else 0o666 & ~umask())
        os.fsync(handle)
    _part.replace(target)
    _part = None


def umask():
    mask = os.umask(0o077)
    os.umask(mask)
    return mask


def _remove_part():
    if _part is not None:
        _part.unlink(missing_ok=True)


RESOURCES = {errno.EAGAIN: "no more processes: raise their limit (ulimit -u)",
             errno.EMFILE: "no more open files: raise their limit (ulimit -n)",
             errno.ENFILE: "no more open files: raise their limit (ulimit -n)",
             errno.ENOMEM: "no more memory: raise its limit (ulimit -v)"}
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def _set_handlers(handler):
    for signum in SIGNALS:
        signal.signal(signum, handler)


def _stop(signum, _):
    _set_handlers(signal.SIG_IGN)  # the first signal ends the command
    raise Stopped(signum)


def failure_of(error):
    """Any exception as a failure."""
    if isinstance(error, Failure):
        return error
    if isinstance(error, OSError) and error.errno in RESOURCES:
        return Failure(NO_RESULT, RESOURCES[error.errno])
    if isinstance(error, MemoryError):
        return Failure(NO_RESULT, RESOURCES[errno.ENOMEM])
    if isinstance(error, OSError):
        return Failure(NOT_WRITTEN, f"{error.filename or 'output'}: cannot be written: {error.strerror}")
    return Failure(INTERNAL, f"internal error, please report it: {error!r}")


def print_message(text, stream=2):
    """Writes a line to standard error, or to another descriptor. If that is closed, full or a pipe that nobody reads,
    the line is lost without a word: no message changes an exit code."""
    with contextlib.suppress(OSError):
        os.write(stream, f"{text}\n".encode("utf-8", "backslashreplace"))


def occupy_standard_streams():
    """Opens those that are closed, so that no file of the run gets their descriptors. Output cannot be written there."""
    for descriptor in range(3):
        try:
            os.fstat(descriptor)
        except OSError:
            os.open(os.devnull, os.O_RDONLY if descriptor < 2 else os.O_WRONLY)


def _print_failure(name, failure):
    if str(failure):
        print_message(f"{name}: {failure}" + (f"\ntry '{name} --help'" if failure.code == USAGE else ""))


def run_command(name, work):
    """Runs work() and ends the process: with 0, with the code of a failure after its message, or by the signal that
    interrupted it."""
    occupy_standard_streams()
    _set_handlers(_stop)
    code = 0
    try:
        work()
        if sys.stdout is not None:
            sys.stdout.flush()
    except Stopped as stopped:
        _remove_part()
        signal.signal(stopped.args[0], signal.SIG_DFL)
        os.kill(os.getpid(), stopped.args[0])
    except Exception as error:
        failure = failure_of(error)
        _print_failure(name, failure)
        code = failure.code
    os._exit(code)  # the interpreter would flush standard output once more, and fail on a full disk
