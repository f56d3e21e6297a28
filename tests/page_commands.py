#!/usr/bin/python3
"""The commands that the pages of the repository show.

    page_commands.py lines [PAGE...]    page, heading and command of every line in a block of code that calls one of
                                        our commands or h5dump, continued lines joined, separated by tabs
    page_commands.py options            page, command and option of every option in such lines and in code within a
                                        sentence, each once
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
TOOLS = [path.stem for path in ROOT.glob("tools/*.cpp") if "-" not in path.stem]
PIPELINES = ["quadplace", "points2step", "drawing2step", "quadbatch", "quadbench", "quadgallery"]
OTHERS = ["h5dump"]  # that read our files, and are installed for tests
CALL = re.compile(r"(?:^|[|;&(\"] ?|\$ |\S+ && |-d '\\n' )(?:pipelines/|build/bin/)?(" +
                  "|".join(TOOLS + PIPELINES + OTHERS) + r")(?= )")
PAGES = ["README.md", "CONTRIBUTING.md", "formats", "lib", "pipelines", "tests"]


def pages(names):
    for name in names or PAGES:
        path = ROOT / name
        yield from sorted(path.rglob("*.md")) if path.is_dir() else [path]
    if not names:
        yield ROOT / "pipelines/quadrille.7.in"


def blocks(path):
    """Yields (heading, line) for each line in a block of code, continued lines joined."""
    heading, fence, whole = "", None, ""
    for line in path.read_text(encoding="utf-8").splitlines():
        begins = line.startswith(("```", ".EX", ".EE"))
        if begins:
            fence = None if fence is not None or line == ".EE" else line.removeprefix("```")
        elif fence is None and re.match(r"#|\.SH", line):
            heading = re.sub(r"^(#+|\.SH) ", "", line)
        elif fence in ("", "sh", "python", ".EX") or fence is None and line.startswith("    "):
            whole += line.strip()
            if whole.endswith("\\") and path.suffix == ".md":
                whole = whole[:-1]
                continue
            yield heading, whole.removeprefix("$ ").replace("\\-", "-")
        whole = ""


def lines(path):
    for heading, line in blocks(path):
        if CALL.search(line) and not line.startswith("@producer"):
            yield heading, line


def spans_of(path):
    if path.suffix != ".md":
        return []
    text = re.sub(r"```.*?```", "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
    return [" ".join(span.split()) for span in re.findall(r"`([^`]+)`", text)]


def inline(path):
    """Yields (command,): those that name a file to read, or a folder to write."""
    for span in spans_of(path):
        if re.match(CALL, span) and re.search(r" [a-z]+\.(step|[a-z]+\.(h5|json))\b|--to ", span):
            yield (span,)


def options(path):
    """Yields (command, option)."""
    spans = [line for _, line in lines(path)] + spans_of(path)
    for span in spans:
        for call in re.split(r"[|;]| && ", span):
            match = re.match(r"\s*(?:pipelines/|build/bin/)?([a-z0-9]+) ", call)
            if match and match[1] in TOOLS + PIPELINES:
                for option in re.findall(r"(?<=\s)--[a-z][a-z-]+", call.split(" # ")[0]):
                    yield match[1], option


if __name__ == "__main__":
    kind, *names = sys.argv[1:]
    rows = dict.fromkeys((path.relative_to(ROOT), *row) for path in pages(names)
                         for row in {"lines": lines, "inline": inline, "options": options}[kind](path))
    for row in rows:
        print(*row, sep="\t")
