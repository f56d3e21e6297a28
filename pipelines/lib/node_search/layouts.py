"""Runs the stages for given irregular nodes and measures the blocks."""
import json
import pathlib
import subprocess
from dataclasses import dataclass

from command_frame import Failure, Stopped, print_message


def run_stage(*words, is_trial=False):
    """Runs one tool, and fails with its exit code. Its messages are shown, except in trials, many of which fail."""
    process = subprocess.Popen([str(word) for word in words], stderr=subprocess.PIPE, text=True, errors="replace")
    try:
        messages = process.communicate()[1]
    except Stopped:
        process.terminate()
        process.wait()
        raise
    if not is_trial and messages:
        print_message(messages.removesuffix("\n"))
    if process.returncode:
        code = process.returncode if process.returncode > 0 else 128 - process.returncode
        raise StageFailure(code, words[0], messages)


class StageFailure(Failure):
    """Of a tool, which has printed its message. `error` is that message without the name."""

    def __init__(self, code, stage, messages):
        super().__init__(code)
        self.stage = stage
        self.error = messages.partition("\n")[0].partition(": ")[2]


@dataclass(frozen=True)
class Layout:
    """The nodes (the content of x.crit.json), the folder of their files, of the blocks the least scaled Jacobian, the
    greatest ratio of sides and the number, and the angle between crosses and the directions of a file, in degrees."""

    nodes: dict
    folder: pathlib.Path
    quality: float
    edge_ratio: float = 1.0
    num_blocks: int = 1
    misalignment: float = 0.0


def make_layout(nodes, folder, first, is_trial):
    """The layout with these nodes, in a new folder. `first` is the folder of the triangle mesh and of its field."""
    folder.mkdir(exist_ok=True)
    crit, sep, blocks = folder / "crit.json", folder / "sep.json", folder / "blocks.h5"
    crit.write_text(json.dumps(nodes, indent=1))
    is_phase = nodes.get("form") == "phase"
    field = make_phase(folder, first, is_trial) if is_phase else first / "field.h5"
    run_stage("separatrix", "-q", field, crit, "-o", sep, is_trial=is_trial)
    if json.loads(sep.read_text())["certificate"]["method"] == "midpoint":  # blocks that do not depend on the nodes
        raise Failure(1, "with these nodes there are no blocks but divided triangles, which do not depend on them: "
                         "use quadmesh, or give other nodes by --start")
    run_stage("blocksplit", "-q", sep, "-o", blocks, is_trial=is_trial)
    return Layout(nodes, folder, *block_measures(folder), misalignment(folder if is_phase else first))


def make_phase(folder, first, is_trial):
    """A field with the nodes of folder/crit.json."""
    solve, phase = folder / "solve.h5", folder / "phase.h5"
    known = "--nodes", folder / "crit.json", "--orders", first / "field.h5"
    run_stage("fieldsolve", "-q", *known, *align_words(first, folder), first / "tri.h5", "-o", solve, is_trial=is_trial)
    run_stage("padapt", "-q", solve, "-o", phase, is_trial=is_trial)
    solve.unlink()
    return phase


def align_words(first, folder):
    """Words with which fieldsolve measures the angles between crosses and the directions of a file, and writes them to the
    folder; the field stays as it is. `first`: the folder with the file, if there is any."""
    file = first / "align"
    return ("--align", file, "--align-strength", 0, "--report", folder / "field.json") if file.exists() else ()


def misalignment(folder):
    """Degrees, the root of the mean square; 0 where it was not measured."""
    report = folder / "field.json"
    return json.loads(report.read_text())["align"]["rms_degrees"] if report.exists() else 0.0


def block_measures(folder):
    """The least scaled Jacobian, 0 where a block is not valid, the greatest ratio of sides and the number, of the blocks as
    one quad of order 8 each."""
    report = folder / "report.json"
    coarse = ("--size", 1e300, "--order", 8, "--geometry-tol", 1, "--target-edge-ratio", 0, "--allow-invalid", "--report",
              report)
    run_stage("quadrefine", "-q", *coarse, folder / "blocks.h5", "-o", folder / "coarse.h5", is_trial=True)
    measured = json.loads(report.read_text())
    quality = measured["least_scaled_jacobian"] if measured["valid"] else 0.0
    return quality, measured["greatest_edge_ratio"]["value"], measured["blocks"]
