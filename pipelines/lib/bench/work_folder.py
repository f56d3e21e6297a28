"""The stage files of a shape in a folder of quadmesh --workdir: which stages a change of the options makes old, and the
run of quadmesh that makes these again."""
import contextlib
import json
import os
import pathlib

import command_frame as frame
from bench.state import NODE_RULES, STAGES, words_of

FILES = dict(zip(STAGES, ("tri.h5", "solve.h5", "field.h5", "crit.json", "sep.json", "blocks.h5", "quad.h5")))
ALWAYS = ("--threads", "--max-seconds", "--max-memory", "--stage")  # options that --from does not refuse
NODES = STAGES.index("critpoints")


def has_nodes_file(option, value):
    return option == "--nodes" and value not in NODE_RULES


def last_stage(option, value):
    """The number of the last stage that takes an option: --from a later one refuses it."""
    if option in ALWAYS:
        return len(STAGES)
    if option == "--nodes":
        return NODES + has_nodes_file(option, value)
    return max((k for k, stage in enumerate(STAGES) if option in frame.option_kinds(stage)), default=0)


def commands_of_stages(dry_run):
    """The commands of each stage, as one text, from what quadmesh --dry-run prints. What makes a shape a CAD face, or a
    chart of it, belongs to cad2tri."""
    commands = {stage: "" for stage in STAGES}
    for line in dry_run.splitlines():
        if line.startswith(("#", "mkdir")):
            continue
        tool = line.partition(" ")[0]
        stage = tool if tool in commands else "critpoints" if tool == "cp" else "cad2tri"
        commands[stage] += line + "\n"
    return commands


class WorkFolder:
    """`made`: the commands of each stage whose file is there. `report`: of the last run that ended well, with the
    warnings of all stages whose files are there."""

    def __init__(self, folder, stem):
        self.folder, self.stem = pathlib.Path(folder), stem
        self.aside = self.folder / "aside"
        self.aside.mkdir(parents=True)
        self.made, self.report = {}, {}

    def file(self, stage):
        return self.folder / f"{self.stem}.{FILES[stage]}"

    def mesh(self, name):
        """Where a mesh of this name is written. Some formats need the last folders of a name."""
        path = self.folder.joinpath("mesh", *pathlib.PurePath(name).parts[-3:])
        path.parent.mkdir(parents=True, exist_ok=True)
        return path

    def first_changed(self, commands, end=len(STAGES)):
        """The number of the first stage before `end` that these commands make again, or `end`."""
        return next((k for k, stage in enumerate(STAGES[:end]) if self.made.get(stage) != commands[stage]), end)

    @contextlib.contextmanager
    def renewed(self, first):
        """The files of stages from this number on are out of the way; if no new ones are made, they come back."""
        made, report = self.made, self.report
        files = [file for stage in STAGES[first:] if stage in FILES and (file := self.file(stage)).exists()]
        for file in files:
            file.replace(self.aside / file.name)
        self.made = {stage: made[stage] for stage in STAGES[:first] if stage in made}
        try:
            yield
        except BaseException:
            self.made, self.report = made, report
            for file in files:
                (self.aside / file.name).replace(file)
            raise

    def words(self, shape, options, first, end):
        """Of the command that runs the stages from number `first` up to before `end`."""
        kept = [(option, value) for option, value in options if first == 0 or last_stage(option, value) >= first]
        limits = ["--from", STAGES[first]] * (first > 0) + ["--until", STAGES[end - 1]] * (end < len(STAGES))
        return ["quadmesh", "-q", shape, *words_of(kept), "--workdir", str(self.folder), *limits]

    def update(self, process, shape, options, commands, mesh, end=len(STAGES)):
        """Makes the files before stage `end` that are old. `process.run(words)`: exit code, what is printed, messages.
        What the last stages cannot do, the chain may do in another way, with other nodes or without a field."""
        first = self.first_changed(commands, end)
        if first == end:
            return
        try:
            self.run(process, shape, options, commands, mesh, first, end)
        except frame.Failure as failure:
            again = NODES + 1 if any(has_nodes_file(*option) for option in options) else NODES
            if failure.code != frame.NO_RESULT or first <= again:
                raise
            self.run(process, shape, options, commands, mesh, again, end)

    def run(self, process, shape, options, commands, mesh, first, end):
        """Runs the stages from number `first` up to before `end`. A Failure has the message of the stage."""
        with self.renewed(first):
            output = ["-o", str(self.mesh(mesh))] if end == len(STAGES) else []
            code, printed, messages = process.run([*self.words(shape, options, first, end), "--report", "-", *output])
            found = report_in(printed)
            if code:
                raise frame.Failure(code, failure_text(found, messages))
            self.note(first, end, commands, found)

    def note(self, first, end, commands, report):
        """What a run has made."""
        kept = [w for w in self.report.get("warnings", []) if w["tool"] in STAGES[:first]]
        self.report = report | {"warnings": kept + [w for w in report.get("warnings", []) if w not in kept]}
        # Without a field, quads are made of other blocks than those that the next sizes begin with.
        done = end if report.get("given_up") is None else NODES
        self.made |= {stage: commands[stage] for stage in STAGES[:done]}

    def link(self, other, commands):
        """The triangles and the field of another folder take the place of all files."""
        for stage in FILES:
            self.file(stage).unlink(missing_ok=True)
        for stage in ("cad2tri", "padapt"):
            os.link(other.file(stage), self.file(stage))
        self.made = {stage: commands[stage] for stage in STAGES[:NODES]}
        self.report = {"warnings": [w for w in other.report["warnings"] if w["tool"] in STAGES[:NODES]]}

    def nodes(self):
        """The content of x.crit.json; None where quads were made without nodes."""
        with contextlib.suppress(FileNotFoundError):
            return json.loads(self.file("critpoints").read_text(encoding="utf-8"))
        return None

    def diameter(self):
        """Of the face."""
        return json.loads(self.file("separatrix").read_text(encoding="utf-8"))["face"]["diameter"]


def report_in(text):
    try:
        return json.loads(text)
    except ValueError:
        return {}


def failure_text(report, messages):
    """STAGE: MESSAGE of a run that failed."""
    if report.get("error"):
        return f"{report.get('stage') or 'quadmesh'}: {report['error']}"
    return messages.partition("\n")[0] or "quadmesh failed without a message"
