"""Errors and warnings of the tools, and where the tools are."""
import os
import pathlib
import re
import shutil

REMEDIES = re.compile(r"(?:: |; |\? )((?:ask|begin|check|choose|cut|draw|end|export|give|install|leave|look|lower|make|"
                      r"mend|move|name|omit|quote|raise|remove|repair|run|split|use|write|did you mean)\b.*)$", re.DOTALL)


class ToolError(Exception):
    """What a tool refused or could not do: `code`, its exit code (1: no valid result, 2: options, 3: an input, 4: an
    output, 70: an internal error, 128 + n: signal n); `stage`, which one; `text`, its message; `remedy`, the part of it
    that says what to do, which may be empty; `report`, a dict, if it wrote one."""

    def __init__(self, code, stage, text, report=None):
        super().__init__(f"{stage}: {text}")
        self.code, self.stage, self.text, self.report = code, stage, text, report
        found = REMEDIES.search(text)
        self.remedy = found[1] if found else ""

    def __reduce__(self):
        return type(self), (self.code, self.stage, self.text, self.report)


class ToolWarning(UserWarning):
    """A warning of a tool: `code`, W-STAGE-NNN (formats/report.md), and `stage`."""

    def __init__(self, stage, code, text):
        super().__init__(f"{stage}: {code}: {text}")
        self.stage, self.code = stage, code


def tool_path(name):
    """The program: in $QUADRILLE_BIN, in the build beside these sources, in the `bin` beside this package, or on PATH."""
    package = pathlib.Path(__file__).resolve()
    for folder in (os.environ.get("QUADRILLE_BIN"), package.parents[3] / "build" / "bin", package.parents[4] / "bin"):
        if folder and os.access(pathlib.Path(folder) / name, os.X_OK):
            return str(pathlib.Path(folder) / name)
    found = shutil.which(name)
    if found is None:
        raise ToolError(1, name, "there is no such program in $QUADRILLE_BIN, beside this package or on PATH: install "
                                 "Quadrille, or run pipelines/quickstart")
    return found
