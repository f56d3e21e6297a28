#!/usr/bin/python3
"""Checks the pages of the project against each other and against the sources. Used by tests/pages.bats:

    pages.py ROOT links [PAGE...]     links between pages, of all or of these only
    pages.py ROOT citations | options | folders | schemas | warnings | keys | terms
    pages.py ROOT keys TOOL REPORT...     the members of these reports are on the page

Prints a line for each fault; exit code 1 if there are any."""
import json, pathlib, re, sys

ROOT = pathlib.Path(sys.argv[1]).resolve()
CODE_ENDINGS = (".hpp", ".cpp", ".bats", ".bash", ".py", ".sh", ".txt")
SOURCE_FOLDERS = ("lib", "tools", "tests", "pipelines")
AREAS = sorted(path for path in (ROOT / "lib").glob("*") if path.is_dir())
FOLDERS = {path.name: path for area in AREAS for path in sorted(area.iterdir()) if path.is_dir()}
faults = []


def fault(where, text):
    faults.append(f"{where.relative_to(ROOT)}: {text}")


def is_ours(path):
    parts = path.relative_to(ROOT).parts
    return not parts[0].startswith(("build", ".git")) and parts[:2] != ("tests", "data")


def pages():
    return sorted(path for path in ROOT.rglob("*.md") if is_ours(path))


def sources():
    """Sources and scripts, this one left out: its patterns look like what it searches for."""
    files = [path for folder in SOURCE_FOLDERS for path in (ROOT / folder).rglob("*") if path.is_file() and is_ours(path)]
    files += [ROOT / "CMakeLists.txt", ROOT / "Makefile.example"]
    return sorted(path for path in files if (path.suffix in CODE_ENDINGS or not path.suffix) and
                  path.name not in ("pages.py", "pages.bats") and path.suffix != ".pyc" and "results" not in path.parts and
                  not {"passed", "failed"} & set(path.parts))


def scripts():
    return [path for path in (ROOT / "pipelines").rglob("*") if path.is_file() and path.suffix != ".pyc"]


def without_code(text):
    """A page without its blocks of code: what is left are prose, tables and headings."""
    text = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
    return re.sub(r"(?m)^\n(?:    .*\n)+", "\n", text)


def headings(page):
    return [re.sub(r"[`*]", "", h).strip() for h in re.findall(r"(?m)^#+ (.*)$", without_code(page.read_text()))]


def anchors(page):
    """As GitHub makes them from headings."""
    found = {}
    for heading in headings(page):
        text = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).lower()
        slug = re.sub(r"[^\w\- ]", "", text).replace(" ", "-")
        found[slug] = found.get(slug, -1) + 1
        if found[slug]:
            found[f"{slug}-{found[slug]}"] = 0
    return found


def check_links(*names):
    count = 0
    for page in [ROOT / name for name in names] or pages():
        prose = re.sub(r"`[^`\n]*`", "", without_code(page.read_text()))
        for target in re.findall(r"\]\(([^)\s]+)\)", prose):
            if re.match(r"[a-z]+:", target):
                continue
            count += 1
            name, _, anchor = target.partition("#")
            file = (page.parent / name).resolve() if name else page
            if not file.exists():
                fault(page, f"the link {target} leads nowhere")
            elif anchor and anchor not in anchors(file):
                fault(page, f"the link {target} names no heading of {file.name}")
    return count


def page_of(citing, name):
    """The page that a comment or another page means: a path from the root, or beside it."""
    if name == "README":
        return ROOT / "README.md"
    for base in (ROOT, citing.parent):
        if (base / name).is_file():
            return base / name
    return None


def check_citations():
    count = 0
    method = {heading.split(". ")[0] for heading in headings(ROOT / "lib/method.md") if re.match(r"\d", heading)}
    for file in pages() + sources():
        text = file.read_text(errors="replace")
        if file.suffix == ".md":
            text = re.sub(r"\]\([^)]*\)", "]", text)  # links have a check of their own
        elif file.suffix in (".hpp", ".cpp"):
            text = "\n".join(re.findall(r"//.*", text))
        joined = re.sub(r"\n *(?://+|#|\*)? *", " ", text)
        for name in re.findall(r"(?<![\w/.$}-])([\w./-]+\.md)\b", text):
            count += 1
            if not is_placeholder(name) and not page_of(file, name):
                fault(file, f"cites {name}, which does not exist")
        for number in re.findall(r"§(\d+(?:\.\d+)?)", text):
            count += 1
            if number not in method:
                fault(file, f"cites §{number}, which lib/method.md does not have")
        for name, heading in re.findall(r"\b(README|[\w./-]+\.md), \"([^\"]+)\"", joined):
            count += 1
            page = page_of(file, name)
            if page and heading not in headings(page) and f"**{heading}.**" not in page.read_text():
                fault(file, f"cites {name}, \"{heading}\": there is no such heading")
        count += check_paths(file, text)
    return count


def is_placeholder(path):
    return bool(re.search(r"[A-Z*{}<>$%]|\.\.", re.sub(r"README|LICENSE|CHANGELOG|CMakeLists", "", path)))


def check_paths(file, text):
    """Files of the project that pages and comments name: tests/x/y, lib/x, guide/winding.hpp, guide/winding."""
    count = 0
    for path in re.findall(r"(?<![\w/.$}\"-])((?:tests|lib|tools|pipelines|formats)/[\w./*{}<>$-]+)", text):
        path = path.rstrip(".-")
        if is_placeholder(path) or path.startswith(("tools/common",)):
            continue
        count += 1
        if not any((base / path).exists() or list((base / path).parent.glob(pathlib.Path(path).name + "[._]*"))
                   for base in (ROOT, file.parent)):
            fault(file, f"names {path}, which does not exist")
    if file.suffix in (".md", ".hpp", ".cpp"):
        for path in re.findall(rf"(?<![\w/.\"<-])((?:{'|'.join(FOLDERS)})/[a-z]\w+(?:\.[hc]pp)?)\b", text):
            if not is_placeholder(path):
                count += 1
                pattern = path if path.endswith("pp") else path + ".[hc]pp"
                if not (ROOT / "lib" / path).is_dir() and not list((ROOT / "lib").glob(f"*/{pattern}")):
                    fault(file, f"names {path}, which is not in lib")
    return count


def check_page(folder, lines):
    """The page of a folder or an area of lib: how it begins, what goes in and out, a header to start with."""
    page = folder / "README.md"
    if not page.is_file():
        faults.append(f"{folder.relative_to(ROOT)} has no README.md")
        return
    text = page.read_text()
    if len(text.splitlines()) > lines:
        fault(page, f"has more than {lines} lines")
    if not text.startswith(f"# {folder.name}: "):
        fault(page, f"does not begin with '# {folder.name}: '")
    for part in ("- In: ", "- Out: "):
        if part not in text:
            fault(page, f"has no '{part}'")
    header = re.search(r"Start with \[[\w.]+\]\(([\w/]+\.hpp)\)", text)
    if not header or not (folder / header[1]).is_file():
        fault(page, "names no header of the folder to start with")


def check_folders():
    for folder in FOLDERS.values():
        check_page(folder, lines=15)
    for area in AREAS:
        check_page(area, lines=50)
    return len(AREAS) + len(FOLDERS)


def check_schemas():
    listed = (ROOT / "formats/README.md").read_text()
    schemas = sorted((ROOT / "formats").glob("*.schema.json"))
    for schema in schemas:
        if f"]({schema.name})" not in listed:
            faults.append(f"formats/README.md does not list {schema.name}")
    return len(schemas)


def compiled():
    return [path for folder in ("lib", "tools") for path in (ROOT / folder).rglob("*.?pp")]


def rows_of(page, section):
    """First cells of the tables below a heading, up to the next heading of the same level."""
    level = len(section.split()[0])
    text = page.read_text().split(f"\n{section}\n")[1]
    return re.findall(r"(?m)^\| `([^`]+)` \|", re.split(rf"(?m)^#{{1,{level}}} ", text)[0])


def check_warnings():
    """The codes of base/warning_codes.hpp are all in use, and are those of the page; no other source spells one out."""
    page, header = ROOT / "formats/report.md", ROOT / "lib/core/base/warning_codes.hpp"
    listed = rows_of(page, "## Warnings")
    named = dict(re.findall(r"(\w+) = \"(W-[A-Z]+-\d+)\";", header.read_text()))
    used = set()
    for path in compiled():
        code = re.sub(r"//.*", "", path.read_text())
        used |= set(re.findall(r"\bwarning::(\w+)", code))
        for literal in re.findall(r"\"(W-[A-Z]+-\d+)\"", code) if path != header else []:
            fault(path, f"spells out the warning {literal}, which {header.name} should name")
    for name in sorted(set(named) - used):
        fault(header, f"names {name}, which no source issues")
    codes = [*named.values(), *re.findall(r"\bW-[A-Z]+-\d+\b", "\n".join(path.read_text() for path in scripts()))]
    for code in sorted(set(codes) - set(listed)):
        fault(page, f"does not list the warning {code}")
    for code in sorted(set(listed) - set(codes)):
        fault(page, f"lists {code}, which no source issues")
    for name, codes_given in (("lists", listed), ("gives a name to", list(named.values()))):
        for code in sorted({code for code in codes_given if codes_given.count(code) > 1}):
            fault(page if name == "lists" else header, f"{name} {code} twice")
    return len(named)


def first_argument(text):
    """Up to the comma or closing bracket that ends the first argument of a call."""
    depth, quoted, k = 0, False, 0
    while k < len(text):
        c = text[k]
        if quoted:
            k += c == "\\"
            quoted = c != '"'
        elif c == '"':
            quoted = True
        elif c in "([{":
            depth += 1
        elif c in ")]}":
            if depth == 0:
                break
            depth -= 1
        elif c == "," and depth == 0:
            break
        k += 1
    return text[:k].strip()


def pattern(expression, code, seen=()):
    """A key's expression as a regular expression: strings as they are, values of a format as [^.]+, variables as they were
    last defined in the code before, or .*"""
    expression = expression.strip()
    if match := re.fullmatch(r"fmt::format\((.*)\)", expression, re.S):
        expression = first_argument(match[1])
    result = ""
    for part in re.split(r"\s*\+\s*(?=(?:[^\"]*\"[^\"]*\")*[^\"]*$)", expression):
        if strings := re.findall(r"\"([^\"]*)\"", part):
            result += re.escape("".join(strings)).replace(r"\{\}", "[^.]+")
        elif (definitions := re.findall(rf"\b{re.escape(part)}\b = ([^;]*);", code)) and part not in seen:
            result += pattern(definitions[-1], code, (*seen, part))
        else:
            result += ".*"
    return result


def source_keys():
    """Patterns of all keys that sources set, and where."""
    found = {}
    for path in compiled():
        code = re.sub(r"//.*", "", path.read_text())
        for match in re.finditer(r"\breport_?(?:\(\))?(?:\.|->)set\(", code):
            key = pattern(first_argument(code[match.end():]), code[:match.start()])
            if re.sub(r"\.\*|\[\^\.\]\+", "", key):
                found.setdefault(key, path)
    return found


FIXED_KEYS = {"tool", "version", "warnings"}  # written by io/chain_report for every tool


def page_keys():
    """The keys of formats/report.md by section (tool or tools)."""
    page = ROOT / "formats/report.md"
    sections = re.findall(r"(?m)^### (.*)$", page.read_text())
    return {section: rows_of(page, f"### {section}") for section in sections}


def check_keys():
    page = ROOT / "formats/report.md"
    keys = {key for section, rows in page_keys().items() if section != "quadmesh" for key in rows}
    patterns = source_keys()
    examples = {key: re.sub(r"<\w+>", "1", key) for key in keys}
    for key, path in sorted(patterns.items()):
        if not any(re.fullmatch(key, example) for example in examples.values()):
            fault(path, f"sets the report key {key}, which formats/report.md does not have")
    for key, example in sorted(examples.items()):
        if key not in FIXED_KEYS and not any(re.fullmatch(pattern, example) for pattern in patterns):
            fault(page, f"has the key {key}, which no source sets")
    for section, rows in page_keys().items():
        for key in sorted({key for key in rows if rows.count(key) > 1}):
            fault(page, f"has {key} twice under {section}")
    return len(patterns)


def members(value, prefix=""):
    if isinstance(value, dict):
        return [key for name, inner in value.items() for key in members(inner, f"{prefix}.{name}" if prefix else name)]
    return [prefix]


def check_reports(tool, files):
    """What a tool wrote is in its section or in that of every tool; objects that the page lists whole may hold anything."""
    page = ROOT / "formats/report.md"
    sections = page_keys()
    keys = [key for section, rows in sections.items() for key in rows if re.search(rf"\b{tool}\b", section)]
    if tool != "quadmesh":
        keys += sections["Every tool"]
    regexes = [re.sub(r"<\w+>", "[^.]+", re.escape(key).replace("\\<", "<").replace("\\>", ">")) for key in keys]
    written = {member for file in files for member in members(json.loads(pathlib.Path(file).read_text()))}
    for member in sorted(written):
        if not any(re.fullmatch(regex + (r"(\..*)?" if tool == "quadmesh" else ""), member) for regex in regexes):
            fault(page, f"does not have the key {member} under {tool}")
    if tool == "quadmesh":
        for key, regex in zip(keys, regexes):
            if not any(re.fullmatch(regex + r"(\..*)?", member) for member in written):
                fault(page, f"has the key {key}, which quadmesh does not write")
    return len(written)


def check_terms():
    """Names in code that the tables of the glossary and the pages of lib give exist in lib."""
    code = "\n".join(path.read_text() for path in (ROOT / "lib").rglob("*.?pp"))
    words = set(re.findall(r"\w+", re.sub(r"//.*", "", code)))
    count = 0
    for page in [ROOT / "formats/glossary.md", ROOT / "lib/README.md", *(ROOT / "lib").glob("*/**/README.md")]:
        rows = "\n".join(re.findall(r"(?m)^\|.*", page.read_text())) if page.name == "glossary.md" else page.read_text()
        names = set(re.findall(r"`((?:[A-Z][a-z]+)+|[a-z]+(?:_[a-z]+)+)`", rows))
        count += len(names)
        for name in sorted(names - words):
            fault(page, f"names {name}, which is not in lib")
    return count


def check_options():
    """Options that pages name in running text are those of a tool or pipeline, or of tests/run."""
    programs = [*(ROOT / "tools").glob("*.cpp"), *(ROOT / "lib/program/cli").glob("*.cpp"),
                *(ROOT / "lib/program/chain").glob("*.cpp"), *(ROOT / "lib/program/stage").glob("*.cpp"), ROOT / "tests/run", *scripts()]
    known = set(re.findall(r"--[a-z][a-z-]+", "\n".join(path.read_text() for path in programs)))
    count = 0
    for page in pages():
        for text in re.findall(r"`([^`\n]+)`", without_code(page.read_text())):
            if text.startswith(("cmake ", "ninja ", "build")):
                continue
            for option in re.findall(r"(?<![\w-])--[a-z][a-z-]+", text):
                count += 1
                if option not in known:
                    fault(page, f"names the option {option}, which no command has")
    return count


CHECKS = {"options": check_options, "links": check_links, "citations": check_citations, "folders": check_folders, "schemas": check_schemas,
          "warnings": check_warnings, "keys": check_keys, "terms": check_terms}
check, names = sys.argv[2], sys.argv[3:]
count = check_reports(names[0], names[1:]) if check == "keys" and names else CHECKS[check](*names)
for text in sorted(set(faults)):
    print(text)
if not count:
    print("nothing was checked")
sys.exit(bool(faults) or not count)
