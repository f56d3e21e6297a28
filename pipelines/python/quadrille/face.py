"""The CAD face: its boundary as rational B-splines, loops, joints and names (formats/cad-face.md)."""
import dataclasses
import functools

import numpy as np

from .stage_file import records

GAUSS_POINTS, GAUSS_WEIGHTS = np.polynomial.legendre.leggauss(12)
CELLS_OF_A_SPAN = 8


class Spline:
    """A clamped rational B-spline in the plane; parameters run from `start` to `end`."""

    def __init__(self, degree, knots, poles, weights):
        self.degree = int(degree)
        self.knots = np.asarray(knots, float)
        self.poles = np.asarray(poles, float).reshape(-1, 2)
        self.weights = np.asarray(weights, float)

    @property
    def start(self):
        return self.knots[0]

    @property
    def end(self):
        return self.knots[-1]

    def points(self, t):
        """Points [n, 2] at parameters t [n]."""
        return self.sample(t)[0]

    def derivatives(self, t):
        """Derivatives by t [n, 2]."""
        return self.sample(t)[1]

    def sample(self, t):
        """Points and derivatives [n, 2] at parameters t [n], by de Boor's recurrence of the basis."""
        t = np.clip(np.atleast_1d(np.asarray(t, float)), self.start, self.end)
        last = len(self.poles) - 1
        span = np.clip(np.searchsorted(self.knots, t, side="right") - 1, self.degree, last)
        value, slope = self._basis(t, span)
        poles = np.column_stack([self.poles * self.weights[:, None], self.weights])
        local = poles[span[:, None] - self.degree + np.arange(self.degree + 1)]
        above, rise = np.einsum("ni,nik->nk", value, local), np.einsum("ni,nik->nk", slope, local)
        point = above[:, :2] / above[:, 2:]
        return point, (rise[:, :2] - point * rise[:, 2:]) / above[:, 2:]

    def _basis(self, t, span):
        """Values and derivatives [n, degree + 1] of the functions that are not zero on each span."""
        value, slope = np.ones((len(t), 1)), np.zeros((len(t), 1))
        for k in range(1, self.degree + 1):
            left = self.knots[span[:, None] + 1 - k + np.arange(k)]
            right = self.knots[span[:, None] + 1 + np.arange(k)]
            part = value / (right - left)
            slope = np.zeros((len(t), k + 1))  # of the last k alone: by t, the degree times the differences
            slope[:, :-1] -= k * part
            slope[:, 1:] += k * part
            value = np.zeros((len(t), k + 1))
            value[:, :-1] += (right - t[:, None]) * part
            value[:, 1:] += (t[:, None] - left) * part
        return value, slope

    @functools.cached_property
    def _cells(self):
        """Parameters that cut the curve into cells, and the length up to each."""
        knots = np.unique(self.knots)
        cuts = np.linspace(knots[:-1], knots[1:], CELLS_OF_A_SPAN, endpoint=False, axis=1).ravel()
        cuts = np.append(cuts, knots[-1])
        return cuts, np.concatenate([[0.0], np.cumsum(self._part_length(cuts[:-1], cuts[1:]))])

    def _part_length(self, t0, t1):
        t = (t0 + t1)[:, None] / 2 + (t1 - t0)[:, None] / 2 * GAUSS_POINTS
        speed = np.linalg.norm(self.derivatives(t.ravel()), axis=1).reshape(t.shape)
        return speed @ GAUSS_WEIGHTS * (t1 - t0) / 2

    def length_to(self, t):
        """Arc length from the start to parameters t [n]."""
        t = np.clip(np.atleast_1d(np.asarray(t, float)), self.start, self.end)
        cuts, lengths = self._cells
        cell = np.clip(np.searchsorted(cuts, t, side="right") - 1, 0, len(cuts) - 2)
        return lengths[cell] + self._part_length(cuts[cell], t)

    def parameter_at(self, length):
        """Parameters at arc lengths [n] from the start: Newton's method in the cell, which stays bracketed."""
        length = np.atleast_1d(np.asarray(length, float))
        cuts, lengths = self._cells
        cell = np.clip(np.searchsorted(lengths, length, side="right") - 1, 0, len(cuts) - 2)
        low, high = cuts[cell], cuts[cell + 1]
        t = low + (high - low) * np.clip((length - lengths[cell]) / (lengths[cell + 1] - lengths[cell]), 0, 1)
        for _ in range(8):
            excess = lengths[cell] + self._part_length(cuts[cell], t) - length
            low, high = np.where(excess < 0, t, low), np.where(excess > 0, t, high)
            speed = np.linalg.norm(self.derivatives(t), axis=1)
            t = np.clip(t - excess / np.where(speed > 0, speed, np.inf), low, high)
        return t


@dataclasses.dataclass
class Joint:
    """The start of a curve: angles in radians, the interior angle in (0, 2 pi)."""
    position: np.ndarray
    tangent_in: float
    tangent_out: float
    interior_angle: float
    is_corner: bool


@dataclasses.dataclass
class PeriodicPair:
    """Two curves of which a motion maps the first onto the second, reversed.

    On a curved face it is a motion in space, by `angle` about an axis: at equal fractions of their parameters, one of
    them reversed, both curves have the same node.
    """
    curves: tuple
    angle: float
    shift: np.ndarray
    is_in_space: bool = False

    def move(self, points):
        """Points [n, 2] of the first curve on the second one: turned by `angle` about (0, 0), then moved by `shift`.
        ValueError on a curved face."""
        if self.is_in_space:
            raise ValueError("the sides of a curved face repeat each other in space: no motion of the chart maps them")
        cosine, sine = np.cos(self.angle), np.sin(self.angle)
        return np.asarray(points, float) @ [[cosine, sine], [-sine, cosine]] + self.shift


class Face:
    """The face of a stage file.

    `curves`: Spline, by number; `curve_names`: the name of each; `loops`: ranges of curve numbers, the outline first;
    `joints`: Joint, the start of each curve; `name`, `length_unit`, `diameter`, `origin`.

    `regions`: the range of loops of each region, its outline first; `region_names`: the name of each, that of the face
    if there is one region; `partners`: for each curve the curve of the neighbour in the same place, in the opposite
    direction, or -1; `periodic_pairs`: PeriodicPair.
    """

    def __init__(self, content):
        self.name, self.length_unit = content["name"], content["length_unit"]
        self.origin = np.asarray(content["origin"], float)
        self.diameter = float(content["diameter"])
        self.plane_origin = np.asarray(content["plane_origin"], float)
        self.plane_x, self.plane_y = np.asarray(content["plane_x"], float), np.asarray(content["plane_y"], float)
        self.curve_names = list(content["curve_names"])
        self.curves = read_splines(content["curves"], self.origin)
        offsets = content["loop_offsets"]
        self.loops = [range(int(a), int(b)) for a, b in zip(offsets[:-1], offsets[1:])]
        self.joints = [Joint(np.asarray(j["position"], float) + self.origin, float(j["tangent_in"]),
                             float(j["tangent_out"]), float(j["interior_angle"]), bool(j["is_corner"]))
                       for j in records(content["joints"])]
        offsets = content.get("region_loops", [0, len(self.loops)])
        self.regions = [range(int(a), int(b)) for a, b in zip(offsets[:-1], offsets[1:])]
        self.region_names = list(content.get("region_names", [self.name]))
        self.partners = np.asarray(content.get("partners", [-1] * len(self.curves)), int)
        self.periodic_pairs = [PeriodicPair(tuple(int(c) for c in p["curves"]), float(p["angle"]),
                                            np.asarray(p["shift"], float), "chart" in content)
                               for p in records(content.get("periodic_pairs", []))]

    def region_curves(self, region):
        """Numbers of the curves around a region, a range."""
        loops = self.regions[region]
        return range(self.loops[loops.start].start, self.loops[loops.stop - 1].stop)

    def region_of_curve(self, curve):
        """Number of the region on the left of a curve."""
        return next(r for r in range(len(self.regions)) if curve in self.region_curves(r))

    def interfaces(self):
        """Pairs of curves in one place: of two regions, or of one where it has a slit."""
        return [(i, int(partner)) for i, partner in enumerate(self.partners) if partner > i]

    def named(self, name):
        """Numbers of the curves with this name."""
        return [i for i, curve_name in enumerate(self.curve_names) if curve_name == name]

    def outline(self, points_per_curve=33):
        """Points along each loop [n, 2], for pictures; the first point is repeated at the end."""
        return [np.concatenate([self.curves[i].points(np.linspace(self.curves[i].start, self.curves[i].end,
                                                                  points_per_curve)) for i in loop])
                for loop in self.loops]

    def to_space(self, points):
        """Points [n, 2] of the plane in the space of the CAD model [n, 3]."""
        points = np.asarray(points, float)
        return self.plane_origin + points[..., :1] * self.plane_x + points[..., 1:] * self.plane_y


def read_splines(value, origin):
    """Spline of each record of `curves` or `splines`, with the origin added."""
    return [Spline(r["degree"], r["knots"], np.asarray(r["poles"], float).reshape(-1, 2) + origin, r["weights"])
            for r in records(value)]
