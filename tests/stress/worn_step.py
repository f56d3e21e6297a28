"""STEP text of faces whose edges do not quite meet, as CAD programs write them, for parts.py beside this file."""
import math

from step_text import Step

WEARS = ("vertices", "curves", "radii", "digits")


class WornStep(Step):
    """Leaves gaps of at most `gap` (file units) on purpose: `wear` is what is off.

    vertices  every vertex lies beside the curves that end there
    curves    every curve is moved sideways: neighbours cross beside their vertex, or not at all
    radii     every arc is larger or smaller than its tangential lines ask for: they overlap, or leave a gap
    digits    every coordinate is rounded to the decimal place of the gap
    """

    def __init__(self, rng, wear, gap):
        super().__init__()
        self.rng, self.wear, self.gap = rng, wear, gap
        self.in_curve = False
        self.moved_vertices = {}

    def off(self):
        return self.gap * complex(self.rng.uniform(-0.5, 0.5), self.rng.uniform(-0.5, 0.5))

    def point(self, z):
        if self.wear == "digits":
            place = 10 ** math.floor(math.log10(self.gap))
            z = complex(round(z.real / place) * place, round(z.imag / place) * place)
        return super().point(z)

    def vertex(self, z):
        if self.wear != "vertices":
            return super().vertex(z)
        for known, vertex in self.moved_vertices.items():
            if abs(known - z) < 1e-9:
                return vertex
        self.moved_vertices[z] = super().vertex(z + self.off())
        return self.moved_vertices[z]

    def moved(self, a, b, shift, write):
        """An edge between the vertices of a and b whose curve is moved."""
        vertices = {a: self.vertex(a), b: self.vertex(b)}
        plain, self.vertex = self.vertex, lambda z: vertices[min(vertices, key=lambda known: abs(known - z + shift))]
        try:
            return write()
        finally:
            self.vertex = plain

    def line_edge(self, a, b, name=""):
        if self.wear != "curves":
            return super().line_edge(a, b, name)
        shift = 1j * (b - a) / abs(b - a) * self.rng.uniform(-0.5, 0.5) * self.gap
        return self.moved(a, b, shift, lambda: super(WornStep, self).line_edge(a + shift, b + shift, name))

    def arc_edge(self, centre, radius, a, b, side, name=""):
        shift = self.off() if self.wear == "curves" else 0
        if self.wear == "radii":
            radius += self.rng.uniform(-0.5, 0.5) * self.gap
        return self.moved(a, b, shift, lambda: super(WornStep, self).arc_edge(
            centre + shift, radius, a + shift, b + shift, side, name))


def worn_text(name, loops, rng, wear, gap):
    step = WornStep(rng, wear, gap)
    step.product(name, step.face(loops))
    return step.text(name)
