"""The meshers that tests/benchmarks/peers compares: their commands, CPU times, and sizes for a number of quads."""
import argparse, math, os, re, resource, shlex, shutil, signal, subprocess

import bench, quad_judge

OURS = "quadrille"
TRIES = 8  # runs to find the size that gives the number of quads
FAILURES = 2  # of these, after which a mesher without a mesh is given up
CLOSE = 0.03  # numbers of quads count as equal
GMSH = ("gmsh -2 {step} -o {msh} -format msh41 -nt 1 -order {order} -clmax {size_mm} -setnumber Mesh.RecombineAll 1 "
        "-setnumber Mesh.HighOrderOptimize 1 -setnumber Mesh.Algorithm ")
# Those of Debian's Gmsh 4.8.4 that give nothing but quads, as a rule. Its Frontal-Delaunay for quads (8) ends by signal
# 11 on every face, and blossom recombination alone (RecombinationAlgorithm 1) leaves triangles. Parallelograms differ
# from run to run.
GMSH_MODES = {
    "Gmsh simple full": GMSH + "6 -setnumber Mesh.RecombinationAlgorithm 2",
    "Gmsh blossom full": GMSH + "6 -setnumber Mesh.RecombinationAlgorithm 3",
    "Gmsh parallelograms": GMSH + "9 -setnumber Mesh.RecombinationAlgorithm 3",
    "Gmsh quasi-struct.": GMSH + "11",
}


class Failed(Exception):
    """A mesher ended with an error, or without a mesh."""


class Mesher:
    """A name and a command whose words contain {step}, {msh}, {size}, {size_mm}, {order}."""

    def __init__(self, name, command):
        self.name, self.command = name, command
        missing = [key for key in ("{step}", "{msh}") if key not in command]
        if missing:
            raise ValueError(f"the command of {name} lacks {' and '.join(missing)}")

    def words(self, values):
        fill = lambda match: str(values[match.group(1)])
        return [re.sub(r"\{(step|msh|size|size_mm|order)\}", fill, word) for word in shlex.split(self.command)]

    def is_installed(self):
        return shutil.which(shlex.split(self.command)[0]) is not None

    def run(self, folder, values, timeout):
        """The mesh, and the CPU seconds (user and system) of the command and all that it started and waited for."""
        path = folder / "peer.msh"
        path.unlink(missing_ok=True)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        code, said = run_group(self.words(values | {"msh": path}), folder, timeout)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if code < 0:
            raise Failed(f"ended by signal {-code}")
        if code or not path.exists():
            raise Failed(reason_in(said, folder, values) or f"exit code {code}, no mesh")
        return path, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def run_group(words, folder, timeout):
    """Exit code and output of a command, run in a folder; ends it with all that it started where it takes too long."""
    try:
        process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   cwd=folder, errors="replace", start_new_session=True)
    except OSError as failure:
        raise Failed(f"not started: {failure.strerror}") from failure
    try:
        said, _ = process.communicate(timeout=timeout)
    except subprocess.TimeoutExpired as failure:
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        raise Failed(f"longer than {timeout:g} s") from failure
    return process.returncode, said


def reason_in(output, folder, values):
    """The first error in what a mesher printed, else its last line; without paths."""
    lines = [re.sub(r"\x1b\[[0-9;]*m", "", line).strip() for line in output.splitlines() if line.strip()]
    errors = [line for line in lines if re.match(r"(?i)(error|fatal|\w+: (?!warning)).*[a-z]{2}", line)]
    said = errors[0] if errors else lines[-1] if lines else ""
    for path in (values["step"].parent, folder):
        said = said.replace(f"{path}{os.sep}", "")
    return said if len(said) <= 160 else said[:157] + "..."


def ours():
    quadmesh = bench.ROOT / "pipelines" / "quadmesh"
    command = f"{shlex.quote(str(quadmesh))} -q --frame 3d --order {{order}} --size {{size}} {{step}} -o {{msh}}"
    return Mesher(OURS, command)


def peers(options):
    """The modes of Gmsh, and what --peer names; without those that are not installed, and their names."""
    modes = {} if options.no_gmsh else GMSH_MODES
    meshers = [Mesher(name, command) for name, command in (modes | dict(options.peer)).items()]
    installed = [mesher for mesher in meshers if mesher.is_installed()]
    return installed, [mesher.name for mesher in meshers if mesher not in installed]


def peer(text):
    """NAME=COMMAND as a pair."""
    name, _, command = text.partition("=")
    try:
        Mesher(name, command)
    except ValueError as failure:
        raise argparse.ArgumentTypeError(failure) from failure
    return name, command


def next_size(tried):
    """The size to try after `tried`, pairs (log of the size, log of the number of quads over the wanted one): between
    the last two that enclose the wanted number, or by the rule that it falls with the square of the size. The last and
    not the nearest: numbers jump, and the same size would be tried again."""
    few, many = ([pair for pair in tried if (pair[1] > 0) == is_many] for is_many in (False, True))
    if not few or not many:
        return math.exp(tried[-1][0] + tried[-1][1] / 2)
    low, high = few[-1], many[-1]
    part = low[1] / (low[1] - high[1])
    return math.exp(low[0] + min(max(part, 0.1), 0.9) * (high[0] - low[0]))


def with_count(mesher, folder, values, unit, count, timeout):
    """Runs a mesher with sizes that bring its number of quads to `count`. Returns the size whose number is nearest, its
    mesh (a peer may give another one next time) and CPU seconds, or raises Failed where no size gives quads."""
    tried, failures, size, best = [], [], values["size"], None
    for _ in range(TRIES):
        try:
            path, seconds = mesher.run(folder, sized(values, size, unit), timeout)
            quads, _ = quad_judge.elements_of(path)
        except (Failed, quad_judge.Refused) as reason:
            failures.append(reason)
            if not tried and len(failures) == FAILURES:
                raise Failed(str(failures[0])) from reason
            size *= 0.9
            continue
        tried.append((math.log(size), math.log(quads / count)))
        if abs(tried[-1][1]) == min(abs(off) for _, off in tried):
            best = size, path.replace(folder / "nearest.msh"), seconds
        if abs(tried[-1][1]) < CLOSE or not re.search(r"\{size(_mm)?\}", mesher.command):
            break
        size = next_size(tried)
    return best


def sized(values, size, unit):
    return values | {"size": f"{size:.6g}", "size_mm": f"{size * unit:.6g}"}


def made(mesher, folder, values, unit, count, options):
    """Size, mesh and least CPU seconds of --repeats runs: with a number of quads near `count`, or with the size of
    `values` if that is None."""
    size, runs = values["size"], []
    if count:
        size, *nearest = with_count(mesher, folder, values, unit, count, options.timeout)
        runs.append(nearest)
    while len(runs) < options.repeats:
        runs.append(mesher.run(folder, sized(values, size, unit), options.timeout))
    return size, runs[0][0], min(seconds for _, seconds in runs)
