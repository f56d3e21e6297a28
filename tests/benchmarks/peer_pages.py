"""What tests/benchmarks/peers shows of its rows: a line of each, tables and a plot."""
import statistics, textwrap

import plot

ORDERS = (3, 5)  # of the solutions
ERRORS = [f"{solution}_p{order}" for order in ORDERS for solution in ("smooth", "waves")]
HEADINGS = [key.replace("_", " ") for key in ERRORS]
SIZES = ("greatest_size", "median_size", "least_size")
COLUMNS = (  # key, heading, format
    ("cpu_seconds", "CPU s", "{:.3g}"),
    ("quads", "quads", "{}"),
    ("irregular_nodes", "irregular inside", "{}"),
    ("scaled_jacobian", "scaled Jacobian", "{:.3f}"),
    ("edge_ratio", "edge ratio", "{:.2f}"),
    *((key, key.replace("_", " "), "{:.2f}") for key in SIZES),
    ("resolution_ratio", "R", "{:.2f}"),
    *((key, heading, "{:.2e}") for key, heading in zip(ERRORS, HEADINGS)),
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


def mean(values):
    """Geometric; empty without values."""
    return f"{statistics.geometric_mean(values):.2f}" if values else ""


def accuracy(rows):
    """A row of texts for each shape, with a heading: our errors over the best peer's, and what decides them."""
    columns = (*(f"{key}_ratio" for key in ERRORS), "resolution_ratio", "peers_resolution_ratio", *SIZES)
    table = [["shape", *HEADINGS, "R", "least R of peers", *(key.replace("_", " ") for key in SIZES)]]
    ours = [row for row in rows if row["mesher"] in meshers_of(rows)[:1] and "quads" in row]
    table += [[row["shape"], *(f"{row[key]:.2f}" if key in row else "" for key in columns)] for row in ours]
    for name, of in ("geometric mean", statistics.geometric_mean), ("greatest", max):
        values = [[row[key] for row in ours if "peers_resolution_ratio" in row] for key in columns]
        table.append([name, *(f"{of(column):.2f}" if column else "" for column in values)])
    return table


def summaries(rows):
    """A row of texts for each mesher, with a heading, over the shapes on which its mesh is accepted."""
    meshers = meshers_of(rows)
    reference = accepted(rows, meshers[0]) if meshers else {}
    table = [["mesher", "accepted", "failed", "CPU ratio", "irregular inside, median", "scaled Jacobian, median",
              "least", "edge ratio, median", "greatest", "R, median", *HEADINGS]]
    for mesher in meshers:
        good, mine = accepted(rows, mesher), [row for row in rows if row["mesher"] == mesher]
        values = lambda key: [row[key] for row in good.values() if key in row]
        both = [shape for shape in good if shape in reference and reference[shape]["cpu_seconds"] > 0]
        texts = [f"{len(good)} of {len(mine)}", str(sum(row["verdict"] == "failed" for row in mine)),
                 mean([good[shape]["cpu_seconds"] / reference[shape]["cpu_seconds"] for shape in both])]
        if good:
            texts += [f"{statistics.median(values('irregular_nodes')):g}"]
            texts += [f"{f(values('scaled_jacobian')):.3f}" for f in (statistics.median, min)]
            texts += [f"{f(values('edge_ratio')):.2f}" for f in (statistics.median, max)]
            texts += [f"{statistics.median(values('resolution_ratio')):.2f}"]
            texts += [mean(values(f"{key}_ratio")) for key in ERRORS]
        table.append([mesher, *texts] + [""] * (len(table[0]) - 1 - len(texts)))
    return table


def aligned(table):
    widths = [max(len(row[k]) for row in table) for k in range(len(table[0]))]
    return "\n".join("  ".join(text.ljust(width) for text, width in zip(row, widths)).rstrip() for row in table)


def summary(rows):
    return f"{aligned(accuracy(rows))}\n\n{aligned(summaries(rows))}"


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

Our L2 error over that of the best peer of each shape, at equal unknowns (of a smooth solution and of waves; p: order),
and what decides it: R, 1 for equal squares, and sizes, 1 as prescribed. Means are those of shapes with peers:

{markdown(accuracy(rows))}

![Errors over the best peer's, R and scaled Jacobians](peers.svg)

Over the shapes on which the mesh is accepted; CPU times are geometric means against the first row, errors against the
best peer of each shape:

{markdown(summaries(rows))}

All shapes; errors are those of each mesh with its own number of unknowns:

{markdown(table)}
"""


PANELS = (  # key, title, logarithmic, whether the best is the greatest
    *((f"{key}_ratio", f"{heading}, error over the best peer's", True, False)
      for key, heading in zip(ERRORS, HEADINGS)),
    ("resolution_ratio", "resolution ratio R", True, False),
    ("scaled_jacobian", "least scaled Jacobian", False, True),
)


def draw(path, rows):
    """For each mesher its values on all shapes with an accepted mesh, the best first."""
    panels = []
    for key, title, is_log, descending in PANELS:
        series = {}
        for mesher in meshers_of(rows):
            values = [row[key] for row in accepted(rows, mesher).values() if row.get(key) is not None]
            if values:
                series[mesher] = list(enumerate(sorted(values, reverse=descending), 1))
        if series:
            label = "accepted shapes, the best first"
            panels.append({"title": title, "x": label, "y": title, "y_log": is_log, "series": series})
    if panels:
        plot.plot(path, panels, 3)
