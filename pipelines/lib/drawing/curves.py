"""Curves of a drawing as exact geometry: segments, parts of ellipses, and rational B-splines.

Each curve has `start`, `end`, `range` (its parameters), `at(t)`, `part(t0, t1)`, `mapped(affine)` and `bends()`: pieces
(t0, t1, bound of the second derivative) within which it is smooth, so that a piece of length dt stays within
bound dt^2 / 8 of its chord."""
import bisect
import cmath
import math
from dataclasses import dataclass

SAME_KNOT = 1e-9  # of the range of parameters: a curve is split at a knot that is as near as this
ROUND = 1e-9      # an ellipse whose half axes differ by less than this share is a circle


@dataclass(frozen=True)
class Affine:
    """z -> a z + b conj(z) + c: any affine map of the plane."""

    a: complex = 1
    b: complex = 0
    c: complex = 0

    def __call__(self, z):
        return self.a * z + self.b * z.conjugate() + self.c

    def after(self, first):
        """The map that applies `first`, then this one."""
        return Affine(self.a * first.a + self.b * complex(first.b).conjugate(),
                      self.a * first.b + self.b * complex(first.a).conjugate(), self(complex(first.c)))


def affine_of(xx, xy, yx, yy, x=0.0, y=0.0):
    """Of (u, v) -> (xx u + xy v + x, yx u + yy v + y)."""
    return Affine(complex(xx + yy, yx - xy) / 2, complex(xx - yy, yx + xy) / 2, complex(x, y))


@dataclass(frozen=True)
class Segment:
    start: complex
    end: complex

    range = (0.0, 1.0)
    is_round = False

    def at(self, t):
        return self.start + t * (self.end - self.start)

    def part(self, t0, t1):
        return Segment(self.at(t0), self.at(t1))

    def mapped(self, affine):
        return Segment(affine(self.start), affine(self.end))

    def bends(self):
        return [(0.0, 1.0, 0.0)]


@dataclass(frozen=True)
class Ellipse:
    """centre + p e^it + q e^-it for t from t0 to t1: of a circle one of p and q is 0. An affine map turns these into
    others: p' = a p + b conj(q), q' = a q + b conj(p)."""

    centre: complex
    p: complex
    q: complex
    t0: float = 0.0
    t1: float = 2 * math.pi

    @property
    def range(self):
        return self.t0, self.t1

    @property
    def start(self):
        return self.at(self.t0)

    @property
    def end(self):
        return self.start if self.is_whole else self.at(self.t1)

    @property
    def is_whole(self):
        return abs(self.t1 - self.t0) >= 2 * math.pi * (1 - SAME_KNOT)

    @property
    def is_left(self):
        """Whether it runs counter-clockwise."""
        return abs(self.p) > abs(self.q)

    @property
    def half_axes(self):
        """The major one as a vector, and the length of the minor one."""
        if self.is_circle:
            return complex(abs(self.p) + abs(self.q)), abs(self.p) + abs(self.q)
        turn = cmath.exp(0.5j * (cmath.phase(self.p) + cmath.phase(self.q)))
        return (abs(self.p) + abs(self.q)) * turn, abs(abs(self.p) - abs(self.q))

    @property
    def is_circle(self):
        return min(abs(self.p), abs(self.q)) <= ROUND * max(abs(self.p), abs(self.q))

    def at(self, t):
        turn = cmath.exp(1j * t)
        return self.centre + self.p * turn + self.q * turn.conjugate()

    def part(self, t0, t1):
        return Ellipse(self.centre, self.p, self.q, t0, t1)

    def mapped(self, affine):
        return Ellipse(affine(self.centre), affine.a * self.p + affine.b * complex(self.q).conjugate(),
                       affine.a * self.q + affine.b * complex(self.p).conjugate(), self.t0, self.t1)

    def bends(self):
        return [(self.t0, self.t1, abs(self.p) + abs(self.q))]


def circle(centre, radius, t0=0.0, t1=2 * math.pi):
    return Ellipse(centre, complex(radius), 0j, t0, t1)


def ellipse(centre, major, minor, t0=0.0, t1=2 * math.pi):
    """centre + major cos t + minor sin t, `minor` a vector."""
    return Ellipse(centre, (major - 1j * minor) / 2, (major + 1j * minor) / 2, t0, t1)


def bulged(start, end, bulge):
    """From start to end on a circle; `bulge` is the tangent of a quarter of its angle, positive counter-clockwise."""
    if abs(bulge) < 1e-12:
        return Segment(start, end)
    chord, angle = end - start, 4 * math.atan(bulge)
    centre = (start + end) / 2 + 0.5j * chord * (1 / bulge - bulge) / 2
    first = cmath.phase(start - centre)
    if bulge > 0:
        return circle(centre, abs(start - centre), first, first + angle)
    return Ellipse(centre, 0j, complex(abs(start - centre)), -first, -first - angle)


@dataclass(frozen=True)
class Spline:
    """Of a degree, with all knots (repeated ones too), poles and weights, between the knots at which all basis
    functions count. The value at t is the blossom of (t, ..., t)."""

    degree: int
    knots: tuple
    poles: tuple
    weights: tuple = ()  # all 1 if empty

    @property
    def range(self):
        return self.knots[self.degree], self.knots[len(self.poles)]

    @property
    def start(self):
        return self.at(self.range[0])

    @property
    def end(self):
        return self.at(self.range[1])

    def blossom(self, span, arguments):
        """(weight times value, weight) of the polynomials between the knots span and span + 1."""
        first = span - self.degree
        weights = list(self.weights[first : span + 1]) or [1.0] * (self.degree + 1)
        values = [w * z for w, z in zip(weights, self.poles[first : span + 1])]
        for level, t in enumerate(arguments, 1):
            for i in range(self.degree, level - 1, -1):
                left, right = self.knots[first + i], self.knots[span + 1 + i - level]
                share = (t - left) / (right - left)
                values[i] += (1 - share) * (values[i - 1] - values[i])
                weights[i] += (1 - share) * (weights[i - 1] - weights[i])
        return values[-1], weights[-1]

    def span_of(self, t):
        """The last span that is not empty and begins at t or before."""
        low, high = self.range
        k = bisect.bisect_right(self.knots, min(max(t, low), high)) - 1
        k = min(max(k, self.degree), len(self.poles) - 1)
        while self.knots[k] == self.knots[k + 1]:
            k -= 1
        return k

    def at(self, t):
        value, weight = self.blossom(self.span_of(t), [t] * self.degree)
        return value / weight

    def part(self, t0, t1):
        """With knots at both ends as often as the degree, and once more: its first and last poles are its ends."""
        t0, t1 = self.near_knot(t0), self.near_knot(t1)
        repeated = self.degree + 1
        knots = (t0,) * repeated + tuple(k for k in self.knots if t0 < k < t1) + (t1,) * repeated
        pairs = []
        for j in range(len(knots) - repeated):
            inner = next(i for i in range(j, j + repeated) if knots[i] < knots[i + 1])
            span = self.span_of((knots[inner] + knots[inner + 1]) / 2)
            pairs.append(self.blossom(span, knots[j + 1 : j + repeated]))
        weights = tuple(w for _, w in pairs) if self.weights else ()
        return Spline(self.degree, knots, tuple(value / w for value, w in pairs), weights)

    def near_knot(self, t):
        nearest = min(self.knots, key=lambda k: abs(k - t))
        return nearest if abs(nearest - t) <= SAME_KNOT * (self.range[1] - self.range[0]) else t

    def mapped(self, affine):
        return Spline(self.degree, self.knots, tuple(map(affine, self.poles)), self.weights)

    def bends(self):
        low, high = self.range
        ends = sorted({k for k in self.knots if low <= k <= high})
        return [(a, b, second_derivative(self.part(a, b))) for a, b in zip(ends, ends[1:])]

    def kinks(self):
        """Inner knots where the tangent may jump."""
        low, high = self.range
        return sorted({k for k in self.knots if low < k < high and self.knots.count(k) >= self.degree})


def differences(values):
    return [b - a for a, b in zip(values, values[1:])]


def largest(values):
    return max(map(abs, values), default=0.0)


def second_derivative(bezier):
    """A bound of it, from the poles z w and weights w: z'' = ((z w)'' - 2 z' w' - z w'') / w."""
    n, length = bezier.degree, bezier.range[1] - bezier.range[0]
    weights = bezier.weights or (1.0,) * (n + 1)
    middle = sum(bezier.poles) / (n + 1)
    values = [w * (z - middle) for w, z in zip(weights, bezier.poles)]
    least, reach = min(weights), largest([z - middle for z in bezier.poles])
    first, first_w = (n * largest(differences(v)) for v in (values, weights))
    second, second_w = (n * (n - 1) * largest(differences(differences(v))) for v in (values, weights))
    slope = (first + reach * first_w) / least
    return (second + 2 * slope * first_w + reach * second_w) / least / length**2


def bezier(poles):
    degree = len(poles) - 1
    return Spline(degree, (0.0,) * (degree + 1) + (1.0,) * (degree + 1), tuple(poles))


def smooth_parts(spline):
    """The spline as curves without kinks inside, each with its ends as poles; segments where the degree is 1."""
    ends = [spline.range[0], *spline.kinks(), spline.range[1]]
    parts = [spline.part(a, b) for a, b in zip(ends, ends[1:])]
    return [Segment(part.poles[0], part.poles[-1]) if spline.degree == 1 else part for part in parts]
