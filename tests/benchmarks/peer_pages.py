"""What tests/benchmarks/peers shows of its rows: a line of each, tables and a plot."""
import math, statistics, textwrap

import plot

COLUMNS = (  # key, heading, format
    ("cpu_seconds", "CPU s", "{:.3g}"),
    ("quads", "quads", "{}"),
    ("irregular_nodes", "irregular inside", "{}"),
    ("irregular_on_boundary", "on boundary", "{}"),
    ("scaled_jacobian", "scaled Jacobian", "{:.3f}"),
    ("edge_ratio", "edge ratio", "{:.2f}"),
    ("boundary_distance", "boundary", "{:.1e}"),
    ("l2_equal", "L2 error", "{:.2e}"),
)


def cells(row):
    """The texts of a row; empty where nothing was measured."""
    values = [pattern.format(row[key]) if row.get(key) is not None else "" for key, _, pattern in COLUMNS]
    verdict = row["verdict"] + (f": {row['reason']}" if "reason" in row else "")
    return [row["shape"], row["mesher"], *values, verdict]


def line(row):
    shape, mesher, *values, verdict = cells(row)
    return f"{shape:22} {mesher:20} " + " ".join(f"{value:>8}" for value in values) + f"  {verdict}"


def accepted(rows, mesher):
    return {row["shape"]: row for row in rows if row["mesher"] == mesher and row["verdict"] == "accepted"}


def meshers_of(rows):
    return [mesher for mesher in dict.fromkeys(row["mesher"] for row in rows) if mesher]


def ratio(mine, other, key):
    """The geometric mean of the ratios to the first mesher, over the shapes that both have."""
    pairs = [(mine[shape].get(key), other[shape].get(key)) for shape in mine if shape in other]
    logs = [math.log(a / b) for a, b in pairs if a and b]
    return f"{math.exp(statistics.fmean(logs)):.2f}" if logs else ""


def summaries(rows):
    """A row of texts for each mesher, with a heading, over the shapes on which its mesh is accepted."""
    meshers = meshers_of(rows)
    reference = accepted(rows, meshers[0]) if meshers else {}
    table = [["mesher", "accepted", "failed", "CPU ratio", "irregular inside, median", "on boundary, median",
              "scaled Jacobian, median", "least", "edge ratio, median", "greatest", "L2 error ratio"]]
    for mesher in meshers:
        good, mine = accepted(rows, mesher), [row for row in rows if row["mesher"] == mesher]
        texts = [f"{len(good)} of {len(mine)}", str(sum(row["verdict"] == "failed" for row in mine)),
                 ratio(good, reference, "cpu_seconds")]
        if good:
            values = lambda key: [row[key] for row in good.values()]
            texts += [f"{statistics.median(values(key)):g}" for key in ("irregular_nodes", "irregular_on_boundary")]
            texts += [f"{f(values('scaled_jacobian')):.3f}" for f in (statistics.median, min)]
            texts += [f"{f(values('edge_ratio')):.2f}" for f in (statistics.median, max)]
            texts.append(ratio(good, reference, "l2_equal"))
        table.append([mesher, *texts] + [""] * (len(table[0]) - 1 - len(texts)))
    return table


def summary(rows):
    table = summaries(rows)
    widths = [max(len(row[k]) for row in table) for k in range(len(table[0]))]
    return "\n".join("  ".join(text.ljust(width) for text, width in zip(row, widths)).rstrip() for row in table)


def markdown(table):
    shown = [[text.replace("|", "\\|") for text in row] for row in table]
    shown.insert(1, ["---"] * len(table[0]))
    return "\n".join("| " + " | ".join(row) + " |" for row in shown)


def page(result):
    """The whole page in Markdown."""
    rows, runs = result["rows"], result["repeats"]
    versions = ", ".join(f"{name} {number}" for name, number in result["versions"].items())
    table = [["shape", "mesher", *(heading for _, heading, _ in COLUMNS), "verdict"], *map(cells, rows)]
    machine = f"{result['machine']['cores']} cores ({result['machine']['processor']}) at a load of {result['load']}"
    edges = f"{result['edges']:g} edges to a diameter"
    note = (f"Written by `tests/benchmarks/peers`, whose `--help` explains the columns: {versions}; shape order "
            f"{result['order']}, ours with {edges}, the others with as many quads. CPU seconds "
            f"are {'those of one run' if runs == 1 else f'the least of {runs} runs'}, on {machine}.")
    return f"""# Meshers of quads compared

{textwrap.fill(note, 120)}

Over the shapes on which the mesh is accepted; ratios are geometric means against the first row:

{markdown(summaries(rows))}

All shapes:

{markdown(table)}
"""


PANELS = (  # key, title, logarithmic, whether the best is the greatest, what is added
    ("cpu_seconds", "CPU seconds", True, False, 0),
    ("quads", "quads", True, False, 0),
    ("irregular_nodes", "1 + irregular nodes inside", True, False, 1),
    ("scaled_jacobian", "least scaled Jacobian", False, True, 0),
    ("edge_ratio", "greatest edge ratio", True, False, 0),
    ("l2_equal", "L2 error at our number of unknowns", True, False, 0),
)


def draw(path, rows):
    """For each mesher its values on all shapes with an accepted mesh, the best first."""
    panels = []
    for key, title, is_log, descending, more in PANELS:
        series = {}
        for mesher in meshers_of(rows):
            values = [row[key] + more for row in accepted(rows, mesher).values() if row.get(key) is not None]
            if values:
                series[mesher] = list(enumerate(sorted(values, reverse=descending), 1))
        if series:
            label = "accepted shapes, the best first"
            panels.append({"title": title, "x": label, "y": title, "y_log": is_log, "series": series})
    if panels:
        plot.plot(path, panels, 3)
