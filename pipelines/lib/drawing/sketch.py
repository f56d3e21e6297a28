"""What a drawing holds: curves with names, and the unit of its numbers."""
import pathlib
from dataclasses import dataclass, field

from command_frame import BAD_INPUT, Failure

DEFAULT_UNIT = "mm"


@dataclass(frozen=True)
class Entity:
    """A curve; `layer`: by which it is chosen; `name`: of the edges that it becomes, or ""; `label`: in messages."""

    curve: object
    layer: str
    name: str
    label: str


@dataclass
class Sketch:
    """`unit`: a key of UNITS (outline.step_file); `notes`: sentences on what was read; `warnings`: (code, text)."""

    name: str
    entities: list = field(default_factory=list)
    unit: str = DEFAULT_UNIT
    notes: list = field(default_factory=list)
    warnings: list = field(default_factory=list)
    format: str = ""  # "dxf" or "svg"
    data: bytes = b""  # of the file

    @property
    def title(self):
        return "drawing" if self.name == "standard input" else pathlib.Path(self.name).stem

    def fault(self, message):
        return Failure(BAD_INPUT, f"{self.name}: {message}")


def place(z):
    return f"({z.real + 0.0:.6g}, {z.imag + 0.0:.6g})"


def listed(words, most=5):
    """The first ones, and how many there are beside them."""
    more = len(words) - most
    return ", ".join(words[:most]) + (f" and {more} more" if more > 0 else "")


def counts_in_words(counts):
    """Of a Counter of kinds: "2 HATCH, 1 TEXT"."""
    return listed([f"{count} {kind}" for kind, count in sorted(counts.items())], 9)
