#!/usr/bin/python3
"""Executes a notebook as Jupyter would, in this interpreter: run_notebook.py NOTEBOOK [TAG...]

Cells with one of the tags are left out. What a cell prints or ends with goes to standard output: an expression as text
and, if it draws itself, a line "svg of N bytes", by IPython's formatter where that is installed."""
import ast
import json
import pathlib
import sys


def display(value):
    try:
        from IPython.core.formatters import DisplayFormatter
        shown = DisplayFormatter().format(value)[0]
    except ImportError:
        shown = {"text/plain": repr(value)}
        if hasattr(value, "_repr_svg_"):
            shown["image/svg+xml"] = value._repr_svg_()
    print(shown["text/plain"])
    if "image/svg+xml" in shown:
        print(f"svg of {len(shown['image/svg+xml'])} bytes")


def execute(source, names):
    tree = ast.parse(source)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), names)
    if last is None:
        return
    value = eval(compile(ast.Expression(last.value), "cell", "eval"), names)
    if value is not None:
        display(value)


names = {"__name__": "__main__"}
for cell in json.loads(pathlib.Path(sys.argv[1]).read_text())["cells"]:
    if cell["cell_type"] == "code" and not set(cell["metadata"].get("tags", [])) & set(sys.argv[2:]):
        execute("".join(cell["source"]), names)
