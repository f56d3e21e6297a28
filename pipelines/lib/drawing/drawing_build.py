"""From the curves of a drawing to the text of a STEP file."""
import fnmatch
from dataclasses import dataclass

from command_frame import counted
from drawing import joining, regions
from drawing.curves import ROUND, Ellipse
from drawing.drawing_files import read_drawing
from drawing.sketch import listed
from drawing.step_edges import StepEdges, step_edge
from outline.step_file import step_file

LARGEST = 1e100


@dataclass(frozen=True)
class Settings:
    """The options of drawing2step; None where a default depends on the drawing."""

    unit: str = None
    tolerance: float = None
    layers: str = None
    embed: str = None
    has_all_regions: bool = False


class NameList:
    """NAME,... with patterns, and with ! before the first name all but these."""

    def __init__(self, option, words):
        self.option, self.is_without, self.seen = option, words.startswith("!"), set()
        self.patterns = [word.strip() for word in words.removeprefix("!").split(",")]

    def matches(self, name):
        self.seen.add(name)
        return any(fnmatch.fnmatchcase(name, pattern) for pattern in self.patterns) != self.is_without

    def require_matches(self, sketch):
        """That each pattern matches one of the names that were asked for."""
        for pattern in self.patterns:
            if not any(fnmatch.fnmatchcase(name, pattern) for name in self.seen):
                raise sketch.fault(f"{self.option}: no curve is called '{pattern}'; there are " +
                                   listed(sorted(self.seen), 20))


def read_chosen(path, settings):
    """The drawing, with the curves that --layers names."""
    if settings.layers is None:
        return read_drawing(path, settings.unit, lambda layer: True)
    names = NameList("--drawing-layers", settings.layers)
    sketch = read_drawing(path, settings.unit, names.matches)
    names.require_matches(sketch)
    return sketch


def parted(sketch, edges, settings):
    """(edges that bound faces, edges inside)."""
    if settings.embed is None:
        return edges, []
    names = NameList("--embed", settings.embed)
    is_inner = [names.matches(edge.entity.layer) for edge in edges]
    names.require_matches(sketch)
    return ([edge for edge, inner in zip(edges, is_inner) if not inner],
            [edge for edge, inner in zip(edges, is_inner) if inner])


def graph_of(sketch, settings, tolerance):
    """(edges that bound faces, edges inside them), without crossings and gaps."""
    edges = joining.divided(joining.edges_of(sketch, tolerance), tolerance)
    edges, inner = parted(sketch, joining.kept_once(edges, tolerance, sketch.warnings), settings)
    if not edges:
        raise sketch.fault("no curve bounds a face")
    joining.refuse_crossings(sketch, edges, tolerance)
    joining.refuse_gaps(sketch, edges, joining.diagonal(sketch.entities))
    return edges, inner


def is_usable(curve):
    """Whether all its numbers are finite, and their squares too."""
    values = [value for found in vars(curve).values() for value in (found if isinstance(found, tuple) else (found,))]
    return all(abs(value) <= LARGEST for value in values)


def require_curves(sketch):
    """That there are curves, finite and with an extent in two directions if they are ellipses."""
    if not sketch.entities:
        raise sketch.fault("there is no curve that could bound a face")
    for entity in sketch.entities:
        if not is_usable(entity.curve):
            raise sketch.fault(f"{entity.label} has a number that is not finite, or above {LARGEST:g}")
        if isinstance(entity.curve, Ellipse) and entity.curve.half_axes[1] <= ROUND * abs(entity.curve.half_axes[0]):
            raise sketch.fault(f"{entity.label} is flat: replace it by a line, or leave it out")


def build_faces(sketch, settings, origin=""):
    """(the text of the STEP file, what was found in a sentence). `origin`: as step_file takes it. Throws Failure."""
    require_curves(sketch)
    size = joining.diagonal(sketch.entities)
    tolerance = joining.DEFAULT_TOLERANCE * size if settings.tolerance is None else settings.tolerance
    edges, embedded = graph_of(sketch, settings, tolerance)
    faces, inner = regions.find_faces(sketch, edges, settings.has_all_regions)
    made = StepEdges()
    loops = [(regions.name_of(face) if len(faces) > 1 else "",
              [made.loop(cycle) for cycle in (face.outline, *face.holes)]) for face in faces]
    text = step_file(sketch.title, loops, sketch.unit, size, [step_edge(edge)[0] for edge in embedded + inner],
                     "drawing2step", origin)
    return text, summary(sketch, faces, edges, size)


def summary(sketch, faces, edges, size):
    holes = sum(len(face.holes) for face in faces)
    return (f"{sketch.title}: {counted(len(sketch.entities), 'curve')}, diagonal {size:.6g} {sketch.unit}, "
            f"{counted(len(faces), 'face')}, {counted(holes, 'hole')}, {counted(len(edges), 'edge')}")
