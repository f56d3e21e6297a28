"""What the scripts in this folder share: running tools, their CPU time, the machine, files of results."""
import argparse, json, os, pathlib, re, subprocess, sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
RESULTS = pathlib.Path(__file__).resolve().parent / "results"
PAPER_SHAPES = ("half_disc", "geometry_1", "geometry_2", "geometry_3", "geometry_4", "geometry_5")


def arguments(description, needs_geometries, extra=lambda parser: None):
    """--bin, -o, --repeats and, where needed, the folder of geometries; ends the program where that does not exist. More
    arguments are what extra adds to the parser."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    if needs_geometries:
        parser.add_argument("geometries", nargs="?", type=pathlib.Path, default=ROOT.parent / "shared" / "geometries")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "bin", help="folder of the tools")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=RESULTS, help="folder to write to")
    parser.add_argument("--repeats", type=int, default=5, help="runs of which the least CPU time counts")
    extra(parser)
    options = parser.parse_args()
    if needs_geometries and not (options.geometries / "truth.json").exists():
        print(f"{parser.prog}: no truth.json in {options.geometries}: nothing to do", file=sys.stderr)
        sys.exit(0)
    return options


def run(*command):
    """Runs a command and returns what it wrote."""
    done = subprocess.run([str(c) for c in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode:
        raise RuntimeError(f"{' '.join(map(str, command))}: {done.stderr.strip()}")
    return done.stdout


def report(folder, *command):
    """Runs a tool and returns its report."""
    run(*command, "--report", folder / "report.json")
    return json.loads((folder / "report.json").read_text())


def timed(folder, repeats, phases, *command):
    """The report of a tool, and the least CPU time of its phases together over several runs."""
    reports = [report(folder, *command) for _ in range(repeats)]
    return reports[-1], min(sum(r["timings"][phase]["cpu_seconds"] for phase in phases) for r in reports)


def layout(options, folder, shape, tri_options=(), order=8, separatrix=()):
    """The graph of a shape's layout, through all stages that lead to it, a field for the nodes included; `separatrix`:
    options of that stage."""
    tri, solve, field, crit, sep = (folder / name for name in ("tri.h5", "solve.h5", "field.h5", "crit.json", "sep.json"))
    run(options.bin / "cad2tri", "-q", *tri_options, shape, "-o", tri)
    run(options.bin / "fieldsolve", "-q", "--field-order", order, tri, "-o", solve)
    run(options.bin / "padapt", "-q", solve, "-o", field)
    run(options.bin / "critpoints", "-q", field, "-o", crit)
    if json.loads(crit.read_text())["form"] == "phase":
        run(options.bin / "fieldsolve", "-q", "--nodes", crit, "--orders", field, tri, "-o", solve)
        run(options.bin / "padapt", "-q", solve, "-o", field)
    run(options.bin / "separatrix", "-q", *separatrix, field, crit, "-o", sep)
    return sep


def make_reference(options, folder, shape, diameter, path):
    """CG of order 20 on a mesh of half the size everywhere: half the greatest size (a quarter of the diameter) and
    growth (0.5), and two layers of each fan for one (0.15 = 0.387^2)."""
    tri = folder / "reference.tri.h5"
    halved = ["--size", diameter / 8, "--growth", 0.25, "--fan-factor", 0.387]
    run(options.bin / "cad2tri", *halved, options.geometries / f"{shape}.step", "-o", tri)
    run(options.bin / "fieldsolve", "--field-order", 20, tri, "-o", path)


def field_error(options, field, reference):
    return json.loads(run(options.bin / "field_error", field, reference))


def machine():
    text = run("lscpu")
    model = re.search(r"Model name:\s*(.*)", text).group(1)
    return {"processor": model.strip(), "cores": int(re.search(r"^CPU\(s\):\s*(\d+)", text, re.M).group(1))}


def is_native(tools):
    """Whether the tools in a folder of a build tree were built for this machine (QUADRILLE_NATIVE, as quickstart does)."""
    cache = tools.resolve().parent / "CMakeCache.txt"
    return cache.exists() and "QUADRILLE_NATIVE:BOOL=ON" in cache.read_text()


def rounded(value, digits=4):
    return float(f"{value:.{digits}g}")


def write(path, result):
    """JSON with one row of a table per line."""
    text = json.dumps(result, indent=1, ensure_ascii=False)
    innermost = re.compile(r"\{[^{}]*\}|\[[^\[\]{}]*\]")
    flat = lambda match: match.group(0)[0] + re.sub(r"\s*\n\s*", " ", match.group(0)[1:-1]).strip() + match.group(0)[-1]
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(innermost.sub(flat, text) + "\n", encoding="utf-8")
