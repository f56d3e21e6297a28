"""Drawings of which the tests of pipelines/lib/drawing know everything."""
import math

from drawing import curves, joining
from drawing.curves import Segment
from drawing.sketch import Entity, Sketch

QUARTER = curves.Spline(2, (0, 0, 0, 1, 1, 1), (1, 1 + 1j, 1j), (1, math.sqrt(0.5), 1))  # of the unit circle


def polygon(*points):
    return [Segment(a, b) for a, b in zip(points, [*points[1:], points[0]])]


def square(low, size):
    return polygon(low, low + size, low + size + 1j * size, low + 1j * size)


def sketch_of(layers):
    """`layers`: lists of curves by their layer."""
    sketch = Sketch("sketch.dxf")
    for layer, found in layers.items():
        sketch.entities += [Entity(curve, layer, layer, f"{layer} {i}") for i, curve in enumerate(found)]
    return sketch


def edges_of(layers, tolerance=1e-6):
    sketch = sketch_of(layers)
    return sketch, joining.divided(joining.edges_of(sketch, tolerance), tolerance)


def dxf(*entities, header="", tables="", blocks=""):
    """A DXF file of entities "KIND CODE=VALUE ...", and sections of such words."""
    def pairs(words):
        return [line for word in words.split() for line in (word.split("=", 1) if "=" in word else ("0", word))]

    lines = []
    for name, words in (("HEADER", header), ("TABLES", tables), ("BLOCKS", blocks), ("ENTITIES", " ".join(entities))):
        if words:
            lines += ["0", "SECTION", "2", name, *pairs(words), "0", "ENDSEC"]
    return "\n".join([*lines, "0", "EOF", ""]).encode()
