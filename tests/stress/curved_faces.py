#!/usr/bin/python3
"""Meshes curved faces that the CAD kernel draws (ninja curved_faces), and says what became of them.

    tests/stress/curved_faces.py [--bin DIR] [--count N] [--seed N] [--jobs N] [--seconds N] [--keep FOLDER] [NAME...]

The faces are those of `curved_faces FOLDER N SEED`; a NAME (043_torus_patch, or a part of it) chooses some of them. A
face is good when quadmesh --face 0 ends with 0 and proves every element. Prints each failure with its message, and a
table by family; ends with 1 where more than one of twenty is not meshed, or a run crashed (exit code 70, a signal).
"""
import argparse
import collections
import concurrent.futures
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def meshed(face, args, folder):
    """Exit code and last message of quadmesh, and whether its mesh is proved."""
    report = folder / (face.stem + ".json")
    words = [args.bin / "quadmesh", "-q", face, "--face", "0", "-o", folder / (face.stem + ".msh"), "--report", report,
             "--max-seconds", str(args.seconds), "--threads", "1"]
    run = subprocess.run(words, capture_output=True, text=True, check=False)
    message = run.stderr.strip().splitlines()[-1] if run.stderr.strip() else ""
    is_proved = run.returncode == 0 and '"valid": false' not in report.read_text()
    if run.returncode == 0 and not is_proved:
        message = "mesh not proved valid"
    return run.returncode, is_proved, message


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("names", nargs="*")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "bin")
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--seconds", type=int, default=120)
    parser.add_argument("--keep", type=pathlib.Path)
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        folder = args.keep or pathlib.Path(scratch)
        subprocess.run([args.bin / "curved_faces", folder, str(args.count), str(args.seed)], check=True)
        faces = [face for face in sorted(folder.glob("*.step"))
                 if not args.names or any(name in face.stem for name in args.names)]
        with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
            results = list(pool.map(lambda face: meshed(face, args, folder), faces))
    table = collections.defaultdict(lambda: [0, 0])
    for face, (code, is_proved, message) in zip(faces, results):
        family = face.stem.split("_", 1)[1]
        table[family][0] += is_proved
        table[family][1] += 1
        if not is_proved:
            print(f"{face.stem}: {code}: {message}")
    for family, (good, count) in sorted(table.items()):
        print(f"{family:20} {good:4} of {count}")
    good = sum(is_proved for _, is_proved, _ in results)
    print(f"{good} of {len(results)} faces meshed")
    is_crash = any(code not in (0, 1, 3) for code, _, _ in results)
    return 1 if is_crash or good < 0.95 * len(results) else 0


if __name__ == "__main__":
    sys.exit(main())
