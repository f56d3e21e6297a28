"""The rows of many shapes as one table: CSV for programs, HTML for people."""
import csv
import html
import io
import os
import tempfile
import urllib.parse

COLUMNS = {"shape": "shape", "exit_code": "exit code", "blocks": "blocks", "quads": "quads",
           "irregular_nodes": "irregular nodes", "least_scaled_jacobian": "worst scaled Jacobian",
           "greatest_edge_ratio": "edge-length ratio", "resolution": "resolution ratio", "cpu_seconds": "CPU seconds",
           "warnings": "warnings", "message": "message"}
STYLE = """:root { color-scheme: light dark; --ink: #1c2733; --paper: #fff; --rule: #d5dbe2; --failed: #fdeeec }
@media (prefers-color-scheme: dark) { :root { --ink: #e6edf3; --paper: #12171e; --rule: #2a3440; --failed: #3a1f1d } }
body { font: 15px/1.4 system-ui, sans-serif; margin: 2em; color: var(--ink); background: var(--paper) }
a { color: inherit }
table { border-collapse: collapse }
th, td { padding: .25em .8em; border-bottom: 1px solid var(--rule); text-align: right; vertical-align: middle }
th { position: sticky; top: 0; background: var(--paper); padding: 0 }
th button { font: inherit; font-weight: 600; color: inherit; background: none; border: 0; padding: .4em .8em; cursor: pointer }
th[aria-sort=ascending] button::after { content: " \\2191" }
th[aria-sort=descending] button::after { content: " \\2193" }
th:nth-child(2), td:nth-child(2), th:last-child, td:last-child { text-align: left }
.name { display: block; max-width: 32ch; overflow: hidden; text-overflow: ellipsis; white-space: nowrap }
img { width: 96px; height: 60px; object-fit: contain; background: #fff; border-radius: 4px; display: block }
.failed td { background: var(--failed) }"""
# A click on a head sorts by its column: numbers by size, texts by their letters; a second click turns the order.
SCRIPT = """document.querySelectorAll("th button").forEach((button) => button.onclick = () => {
  const head = button.parentElement, body = document.querySelector("tbody"), at = head.cellIndex;
  const sign = head.ariaSort === "ascending" ? -1 : 1, text = (row) => row.cells[at].textContent;
  const compare = (a, b) => a === "" || b === "" ? (a === "") - (b === "")
    : sign * (isNaN(a) || isNaN(b) ? a.localeCompare(b, undefined, { numeric: true }) : a - b);
  document.querySelectorAll("th").forEach((other) => other.ariaSort = "none");
  head.ariaSort = sign > 0 ? "ascending" : "descending";
  body.append(...[...body.rows].sort((a, b) => compare(text(a), text(b))));
});"""


def cell(row, key):
    value = row.get(key)
    if value is None:
        return ""
    return " ".join(value) if isinstance(value, list) else value


def plain_text(value):
    """A cell that no spreadsheet takes for a formula (OWASP, "CSV injection")."""
    return f"'{value}" if isinstance(value, str) and value.startswith(("=", "+", "-", "@", "\t", "\r")) else value


def csv_text(rows):
    """With the keys of the rows as the first line; what a shape does not have is empty."""
    file = io.StringIO()
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(COLUMNS)
    writer.writerows([plain_text(cell(row, key)) for key in COLUMNS] for row in rows)
    return file.getvalue()


def shown(value):
    return f"{value:.3g}" if isinstance(value, float) else str(value)


def link(name):
    return html.escape(urllib.parse.quote(os.fsencode(name)))


def html_row(row, stem, thumbnail):
    """`thumbnail`: the name of the picture, or None."""
    cells = [html.escape(shown(cell(row, key))) for key in COLUMNS]
    name = f'<span class="name" title="{cells[0]}">{cells[0]}</span>'
    cells[0] = f'<a href="{link(stem(row))}">{name}</a>' if row["exit_code"] == 0 else name
    picture = f'<img src="{link(thumbnail)}" alt="" loading="lazy">' if thumbnail else ""
    attribute = "" if row["exit_code"] == 0 else ' class="failed"'
    return f"<tr{attribute}>" + "".join(f"<td>{text}</td>" for text in [picture, *cells]) + "</tr>\n"


def summary(rows):
    failed = sum(row["exit_code"] != 0 for row in rows)
    quads, seconds = sum(row["quads"] or 0 for row in rows), sum(row["cpu_seconds"] for row in rows)
    return (f"{len(rows)} shapes: {len(rows) - failed} meshes, {failed} failures; {quads} quads, "
            f"{seconds:.1f} CPU seconds")


def html_text(rows, stem, thumbnail):
    """`stem(row)` is the name of the mesh file of a row, to which its shape is linked, `thumbnail(row)` that of its
    picture, or None. Failures come first."""
    ordered = sorted(rows, key=lambda row: row["exit_code"] == 0)
    heads = "".join(f'<th aria-sort="none"><button>{head}</button></th>' for head in COLUMNS.values())
    return ('<!DOCTYPE html>\n<html lang="en">\n<meta charset="utf-8">\n'
            '<meta name="viewport" content="width=device-width, initial-scale=1">\n<title>Meshes</title>\n'
            f"<style>\n{STYLE}\n</style>\n"
            f"<p>{summary(rows)}</p>\n<table>\n<thead><tr><th></th>{heads}</tr></thead>\n<tbody>\n"
            f"{''.join(html_row(row, stem, thumbnail(row)) for row in ordered)}</tbody>\n</table>\n"
            f"<script>\n{SCRIPT}\n</script>\n</html>\n")


def write_whole(path, text):
    """Other processes may write the same file: each to a name of its own, renamed when it is complete. Bytes of names
    that are not UTF-8 are written as \\udcNN."""
    handle, part = tempfile.mkstemp(prefix=f".{path.name}.", dir=path.parent)
    try:
        with open(handle, "w", encoding="utf-8", errors="backslashreplace") as file:
            file.write(text)
        os.chmod(part, 0o666 & ~_umask())
        os.replace(part, path)
    except BaseException:
        os.unlink(part)
        raise


def _umask():
    mask = os.umask(0)
    os.umask(mask)
    return mask


def write_tables(results):
    """table.csv and table.html of all shapes that have a result in the folder."""
    rows = results.all_rows()
    write_whole(results.folder / "table.csv", csv_text(rows))
    mesh = lambda row: f"{results.name(row['shape'])}.{row['ending']}"
    write_whole(results.folder / "table.html", html_text(rows, mesh, lambda row: thumbnail_of(results, row)))


def thumbnail_of(results, row):
    picture = results.thumbnail(row["shape"])
    return picture.name if row["exit_code"] == 0 and picture.exists() else None
