"""The rows of many shapes as one table: CSV for programs, HTML for people."""
import csv
import html
import io
import os
import tempfile
import urllib.parse

COLUMNS = {"shape": "shape", "exit_code": "exit code", "blocks": "blocks", "quads": "quads",
           "irregular_nodes": "irregular nodes", "least_scaled_jacobian": "worst scaled Jacobian",
           "greatest_edge_ratio": "edge-length ratio", "resolution": "resolution ratio", "cpu_seconds": "CPU seconds", "warnings": "warnings",
           "message": "message"}
STYLE = """body { font: 15px/1.4 sans-serif; margin: 2em; color: #222 }
table { border-collapse: collapse }
th, td { padding: .25em .8em; border-bottom: 1px solid #ccc; text-align: right; vertical-align: top }
th { position: sticky; top: 0; background: #fff }
th:first-child, td:first-child, th:last-child, td:last-child { text-align: left }
.failed td { background: #fff0ee }"""


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


def html_row(row, stem):
    cells = [html.escape(shown(cell(row, key))) for key in COLUMNS]
    if row["exit_code"] == 0:
        cells[0] = f'<a href="{html.escape(urllib.parse.quote(os.fsencode(stem(row))))}">{cells[0]}</a>'
    attribute = "" if row["exit_code"] == 0 else ' class="failed"'
    return f"<tr{attribute}>" + "".join(f"<td>{text}</td>" for text in cells) + "</tr>\n"


def summary(rows):
    failed = sum(row["exit_code"] != 0 for row in rows)
    quads, seconds = sum(row["quads"] or 0 for row in rows), sum(row["cpu_seconds"] for row in rows)
    return (f"{len(rows)} shapes: {len(rows) - failed} meshes, {failed} failures; {quads} quads, "
            f"{seconds:.1f} CPU seconds")


def html_text(rows, stem):
    """`stem(row)` is the name of the mesh file of a row, to which its shape is linked. Failures come first."""
    ordered = sorted(rows, key=lambda row: row["exit_code"] == 0)
    heads = "".join(f"<th>{head}</th>" for head in COLUMNS.values())
    return ('<!DOCTYPE html>\n<html lang="en">\n<meta charset="utf-8">\n<title>Meshes</title>\n'
            f"<style>\n{STYLE}\n</style>\n"
            f"<p>{summary(rows)}</p>\n<table>\n<thead><tr>{heads}</tr></thead>\n<tbody>\n"
            f"{''.join(html_row(row, stem) for row in ordered)}</tbody>\n</table>\n</html>\n")


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
    write_whole(results.folder / "table.html", html_text(rows, mesh))
