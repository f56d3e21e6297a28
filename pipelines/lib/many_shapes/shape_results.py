"""Results of many shapes: for each shape NAME the mesh NAME.ENDING, NAME.report.json, and, written last, NAME.result.json,
a row of the table. A shape is to be done if its row is missing, or was made of another content of the shape or of a file
that the options name."""
import hashlib
import json
import os
import pathlib
import re

import command_frame as frame

SHAPE_ENDINGS = (".step", ".stp", ".iges", ".igs", ".brep", ".brp")
FIGURES = ("blocks", "quads", "irregular_nodes", "least_scaled_jacobian", "greatest_edge_ratio",
           "resolution")  # of the report
KEYS = {"shape", "ending", "version", "options", "inputs", "exit_code", *FIGURES, "cpu_seconds", "warnings", "message"}
LONGEST_NAME = 255  # bytes, of all usual file systems
FINAL = (0, 1, 2, 3, 70)  # exit codes that would be the same again; not those of a full disk or a signal


def shape_files(words):
    """The shapes that words of a command line name: files, and those in folders, in alphabetical order."""
    shapes = []
    for word in words:
        if os.path.isdir(word):
            found = sorted(name for name in os.listdir(word) if name.lower().endswith(SHAPE_ENDINGS))
            if not found:
                raise frame.Failure(frame.BAD_INPUT, f"{word} holds no file of {' '.join(SHAPE_ENDINGS)}")
            shapes += [os.path.join(word, name) for name in found]
        else:
            shapes.append(word)
    return shapes


class Results:
    """What lies in the folder. `options` are those of quadmesh, as words; `version` is that of the tools."""

    def __init__(self, folder, ending="msh", options=(), version=""):
        self.folder = pathlib.Path(folder)
        self.ending, self.options, self.version = ending, list(options), version

    def name(self, shape):
        return pathlib.Path(shape).stem

    def mesh(self, shape):
        return self.folder / f"{self.name(shape)}.{self.ending}"

    def report(self, shape):
        return self.folder / f"{self.name(shape)}.report.json"

    def thumbnail(self, shape):
        return self.folder / f"{self.name(shape)}.blocks.svg"

    def row_file(self, shape):
        return self.folder / f"{self.short_name(shape)}.result.json"

    def is_too_long(self, shape):
        """Whether the file system has no room for the names of the results."""
        return len(os.fsencode(f"{self.name(shape)}.result.json")) > LONGEST_NAME

    def short_name(self, shape):
        """The name, or its beginning and a digest where it is too long: the row has a file in any case."""
        if not self.is_too_long(shape):
            return self.name(shape)
        name = os.fsencode(self.name(shape))
        return f"{os.fsdecode(name[:100])}~{hashlib.sha256(name).hexdigest()[:16]}"

    def part(self, shape):
        """The folder in which a shape is meshed."""
        return self.folder / f".{self.name(shape)}.part"

    def row(self, shape):
        """The row of a shape that is done, else None."""
        row = read_row(self.row_file(shape))
        if row is None or (row["shape"], row["options"], row["version"], row["ending"]) != (
                str(shape), self.options, self.version, self.ending) or row["exit_code"] not in FINAL:
            return None
        made = [self.mesh(shape), self.report(shape)] if row["exit_code"] == 0 else []
        inputs = self.digests(shape)
        is_same = row["inputs"] == inputs and None not in inputs.values()
        return row if is_same and all(map(pathlib.Path.exists, made)) else None

    def digests(self, shape):
        """SHA-256 of the shape and of each file that the options name."""
        words = [word.partition("=")[2] if word.startswith("--") else word for word in self.options]
        files = [str(shape), *(word for word in words if os.path.isfile(word))]
        return {file: digest(file) for file in files}

    def new_row(self, shape, inputs, exit_code, cpu_seconds, message, report):
        """`inputs` are the digests before the shape was meshed; `report` is that of quadmesh, or None."""
        row = {"tool": "quadbatch", "version": self.version, "shape": str(shape), "ending": self.ending,
               "options": self.options, "inputs": inputs, "exit_code": exit_code}
        figures = report or {}
        row |= {key: figures.get(key) for key in FIGURES}
        for key, figure in (("greatest_edge_ratio", "value"), ("resolution", "ratio")):
            if isinstance(row[key], dict):
                row[key] = row[key].get(figure)
        row["cpu_seconds"] = cpu_seconds
        row["warnings"] = sorted({warning["code"] for warning in figures.get("warnings", [])})
        return row | {"message": message}

    def all_rows(self):
        """Those of all shapes that have a result in the folder, in the order of their names."""
        rows = (read_row(path) for path in sorted(self.folder.glob("*.result.json")))
        return [row for row in rows if row is not None]


def read_row(path):
    """None if there is none, or a part of one."""
    try:
        row = json.loads(path.read_text(encoding="utf-8"))
        return row if row.get("tool") == "quadbatch" and KEYS <= row.keys() else None
    except (OSError, ValueError, AttributeError):
        return None


def digest(file):
    """None if the file cannot be read."""
    try:
        return hashlib.sha256(pathlib.Path(file).read_bytes()).hexdigest()
    except OSError:
        return None


def message_of(text, exit_code, folder):
    """What quadmesh printed of a failure, in one line, without warnings and the place of its temporary files."""
    lines = [line.strip() for line in text.replace(f"{folder}/", "").splitlines()]
    kept = [line for line in lines if line and not re.search(
        r": warning W-|^xdg-open |: the files of the stages before |^try '", line)]
    if exit_code > 128 and not kept:
        return f"ended by signal {exit_code - 128}"
    return " ".join(kept) or ("" if exit_code == 0 else "no message")
