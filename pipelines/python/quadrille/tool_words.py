"""Options of the tools as keywords: `size_near={"hole": 0.02}` is --size-near hole=0.02.

The tools list their options themselves (--list-options): flags, values, values that may be given several times, and
files that are read. A keyword is an option with _ for -; any of its words may be in the plural (`walls`).

    flag     True or False
    value    a number or text; a sequence is joined by commas, a dict is KEY=VALUE,...
    values   one such value or a list of them; a dict has NAME=VALUE, each once, or NAME:KEY=VALUE,... if it holds
             dicts, as for walls; there a tuple is A:B, a list A,B
    file     a path; bytes or what a stage made; a dict or list is written as JSON

None leaves an option out.
"""
import difflib
import functools
import json
import numbers
import os
import re
import subprocess

from .memory_files import file_name
from .tool_errors import ToolError, tool_path

COMMON = {"--threads": "value"}  # of every tool, and therefore not in its list


@functools.cache
def listed_options(path):
    """The kind of each option of a tool."""
    made = subprocess.run([path, "--list-options"], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=True)
    return COMMON | dict(line.split()[1:] for line in made.stdout.splitlines())


def option_words(tool, options, files, without=()):
    """The words of a command line. `files`: where data in memory get a path (MemoryFiles); `without`: options of
    the tool that the caller does not offer. Raises ToolError, code 2."""
    kinds = {name: kind for name, kind in listed_options(tool_path(tool)).items() if name not in without}
    words = []
    for keyword, value in options.items():
        if value is None:
            continue
        name = option_name(tool, keyword, kinds)
        try:
            words += words_of(name, kinds[name], value, files)
        except TypeError as error:
            raise ToolError(2, tool, f"{keyword}: {error}") from None
    return words


def option_name(tool, keyword, kinds):
    name = "--" + keyword.rstrip("_").replace("_", "-")
    for present in (name, re.sub(r"s(?=-|$)", "", name)):
        if present in kinds:
            return present
    known = [other[2:].replace("-", "_") for other in kinds]
    nearest = difflib.get_close_matches(keyword, known, 1, 0.7)
    hint = f": did you mean {nearest[0]}?" if nearest else f": {tool} --help lists them"
    raise ToolError(2, tool, f"there is no option {keyword}{hint}")


def words_of(name, kind, value, files):
    if kind == "flag":
        if not isinstance(value, bool):
            raise TypeError(f"expected True or False, not {value!r}")
        return [name] if value else []
    if isinstance(value, bool):
        raise TypeError(f"expected a value, not {value!r}")
    if isinstance(value, (str, os.PathLike)):
        return [name, os.fspath(value)]
    if isinstance(getattr(value, "data", value), (bytes, bytearray)):
        return [name, file_name(value, files)]
    if kind == "file":
        return [name, files.path(json.dumps(value).encode(), name)]
    if kind == "values":
        return [word for entry in entries_of(value) for word in (name, entry)]
    return [name, plain(value, ",")]


def entries_of(value):
    """The texts of an option that may be given several times."""
    if isinstance(value, dict):
        return [f"{plain(key, ':')}{':' if isinstance(entry, dict) else '='}{entry_text(entry)}" for key, entry in value.items()]
    return [plain(entry, ",") for entry in (value if isinstance(value, (list, tuple)) else [value])]


def entry_text(entry):
    return plain(entry, ":" if isinstance(entry, tuple) else ",")


def plain(value, separator):
    """A number, a text, or several of them."""
    if isinstance(value, dict):
        return ",".join(f"{key}={plain(entry, ':')}" for key, entry in value.items())
    if isinstance(value, str):
        return value
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if hasattr(value, "__iter__"):
        return separator.join(plain(entry, separator) for entry in value)
    raise TypeError(f"expected a number, a text, or several, not {value!r}")
