"""What the workbench saves in the folder of the shape: the command that makes the mesh, as a script or as a rule of a
makefile, and the irregular nodes. All names are derived from that of the shape."""
import os
import pathlib
import re
import shlex

import command_frame as frame
from bench.state import NODE_RULES, words_of

ENDINGS = {"command": ".quadmesh.sh", "makefile": ".mk", "nodes": ".crit.json"}


def relocated(path, folder):
    """The name of a file as seen from the folder: short inside it, absolute elsewhere; never one like an option."""
    path, folder = os.path.abspath(path), os.path.abspath(folder)
    if not path.startswith(folder.rstrip("/") + "/"):
        return path
    name = os.path.relpath(path, folder)
    return f"./{name}" if name.startswith("-") else name


def is_file_option(option, value):
    """Whether the value is the name of a file that quadmesh reads."""
    is_file = frame.option_kinds("quadmesh").get(option) == "file"
    return is_file or option == "--nodes" and value not in NODE_RULES or option == "--wake" and value != "auto"


class SavedFiles:
    """`shape`: its path; `output`: that of the mesh which the command writes; `inputs`: all files that a run reads."""

    def __init__(self, shape, folder, output, inputs):
        self.folder, self.inputs, self.output = pathlib.Path(folder), inputs, output
        self.shape = relocated(shape, folder)
        self.stem = pathlib.PurePath(shape).stem

    def name(self, what):
        return self.stem + ENDINGS[what]

    def words(self, options):
        """Of the command, in the folder."""
        located = [(option, relocated(value, self.folder) if is_file_option(option, value) else value)
                   for option, value in options]
        return ["quadmesh", self.shape, *words_of(located), "-o", relocated(self.output, self.folder)]

    def script(self, options):
        return (f"#!/bin/sh\n# Meshes {self.shape}; saved by quadbench.\ncd \"$(dirname \"$0\")\" || exit\n"
                f"exec {shlex.join(self.words(options))}\n")

    def makefile(self, options, has_nodes):
        """A rule, for make in the folder or for include."""
        words = self.words(options)
        needed = [self.shape] + [self.name("nodes")] * has_nodes
        for name in (words[-1], *needed):
            if not re.fullmatch(r"[\w.+/@,-]+", name):
                raise frame.Failure(frame.NO_RESULT, f"make would not read the name {name}: rename it, or save the command")
        recipe = shlex.join(words).replace("$", "$$")
        return f"# Meshes {self.shape}; saved by quadbench.\n{words[-1]}: {' '.join(needed)}\n\t{recipe}\n"

    def write(self, what, content):
        """Replaces a file that exists, but none that a run reads, and none outside the folder. Returns its name."""
        path = self.folder / self.name(what)
        if os.path.dirname(os.path.realpath(path)) != os.path.realpath(self.folder):
            raise frame.Failure(frame.NOT_WRITTEN, f"{path}: cannot be written: it is a link out of the folder")
        frame.require_outputs([str(path)], self.inputs)
        frame.write_file(str(path), content)
        if what == "command":
            path.chmod(path.stat().st_mode | 0o111 & ~frame.umask())
        return path.name
