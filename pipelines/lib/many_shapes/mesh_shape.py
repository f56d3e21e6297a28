"""One job of pipelines/quadbatch: meshes one shape, in a folder of its own below the results, and moves what is complete
there; the row of the table is last. The argument is JSON: shape, folder, ending, version, options, threads, verbose,
quadmesh."""
import contextlib
import fcntl
import json
import os
import pathlib
import resource
import shutil
import subprocess
import sys

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parent.parent)]

import command_frame as frame
from many_shapes.shape_results import Results, message_of


def run_quadmesh(words, folder):
    """Runs quadmesh with temporary files in the folder: its exit code, what it printed of errors, its CPU seconds."""
    with open(folder / "messages", "w+", encoding="utf-8", errors="replace") as messages:
        process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=messages,
                                   env=os.environ | {"TMPDIR": str(folder.resolve())})
        try:
            code = process.wait()
        except frame.Stopped as stopped:
            process.send_signal(stopped.args[0])
            process.wait()
            raise
        messages.seek(0)
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        return code if code >= 0 else 128 - code, messages.read(), used.ru_utime + used.ru_stime


@contextlib.contextmanager
def only_job(shape):
    """Waits until no other process meshes the shape. File systems that have no such locks are no reason to stop."""
    with contextlib.ExitStack() as files:
        with contextlib.suppress(OSError):
            fcntl.flock(files.enter_context(open(shape, "rb")), fcntl.LOCK_EX)
        yield


def mesh_shape(job):
    """Returns the row, which is written; another process may just have done so."""
    results = Results(job["folder"], job["ending"], job["options"], job["version"])
    with only_job(job["shape"]):
        row = results.row(job["shape"])
        return row if row is not None and row["exit_code"] == 0 else new_result(job, results, job["shape"])


def new_result(job, results, shape):
    for old in (results.row_file(shape), results.mesh(shape), results.report(shape), results.thumbnail(shape)):
        old.unlink(missing_ok=True)
    work, inputs = results.part(shape), results.digests(shape)
    shutil.rmtree(work, ignore_errors=True)
    made = work / "made"
    try:
        made.mkdir(parents=True)
        words = [job["quadmesh"], "-q", shape, "-o", made / results.mesh(shape).name, "--report", work / "report",
                 "--workdir", work / "stages"]
        code, text, seconds = run_quadmesh([*map(str, words), "--threads", job["threads"], *job["options"]], work)
        report = json.loads((work / "report").read_text(encoding="utf-8")) if code == 0 else None
        message = message_of(text, code, work.resolve())
        row = results.new_row(shape, inputs, code, round(seconds, 3), message, report)
        if code == 0:
            for file in sorted(made.iterdir()):  # the mesh, and what its format has beside it
                file.replace(results.folder / file.name)
            (work / "report").replace(results.report(shape))
            draw_thumbnail(job["quadmesh"], work, results.thumbnail(shape))
        (work / "row").write_text(json.dumps(row, indent=1) + "\n", encoding="utf-8")
        (work / "row").replace(results.row_file(shape))
        return row
    finally:
        shutil.rmtree(work, ignore_errors=True)


def draw_thumbnail(quadmesh, work, picture):
    """A small picture of the blocks for the table, which may lack it."""
    for blocks in work.glob("stages/*.blocks.h5"):
        words = [pathlib.Path(quadmesh).parent / "stageview", "-q", blocks, "--bare", "--width", "300"]
        drawn = subprocess.run([*map(str, words), "-o", str(work / "picture.svg")], stdin=subprocess.DEVNULL,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        if drawn.returncode == 0:
            (work / "picture.svg").replace(picture)


def main():
    job = json.loads(sys.argv[1])
    row = mesh_shape(job)
    if job["verbose"]:
        counts = ", ".join(count(row, key) for key in ("blocks", "irregular_nodes", "quads"))
        words = counts if row["exit_code"] == 0 else f"exit code {row['exit_code']}: {row['message']}"
        print(f"{row['shape']}: {words} ({row['cpu_seconds']:.1f} s)")


def count(row, key):
    name = key.replace("_", " ")
    return f"{row[key]} {name[:-1] if row[key] == 1 else name}"


if __name__ == "__main__":
    frame.run_command("quadbatch", main)
