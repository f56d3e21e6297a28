"""Questions about curves that are answered by halving: each piece stays within `width` of its chord, and the width
falls with the square of its length."""
from outline import polygons

MOST_HALVINGS = 60
HALF = 0.4871  # where a piece is halved: not in the middle, which often lies on another curve of a symmetric drawing


class Piece:
    """The curve between two parameters, from a to b."""

    __slots__ = ("curve", "t0", "t1", "a", "b", "bend", "width")

    def __init__(self, curve, t0, t1, a, b, bend):
        self.curve, self.t0, self.t1, self.a, self.b, self.bend = curve, t0, t1, a, b, bend
        self.width = bend * (t1 - t0) ** 2 / 8

    def halves(self):
        t = self.t0 + HALF * (self.t1 - self.t0)
        z = self.curve.at(t)
        return Piece(self.curve, self.t0, t, self.a, z, self.bend), Piece(self.curve, t, self.t1, z, self.b, self.bend)

    def distance(self, z):
        """A lower bound."""
        return (polygons.distance_to_segment(z, self.a, self.b) if self.a != self.b else abs(z - self.a)) - self.width

    def may_meet(self, other):
        """Whether the neighbourhoods of the chords, as wide as the pieces, may have common points."""
        reach = self.width + other.width
        a, b, c, d = self.a, self.b, other.a, other.b
        for one, two in (((a.real, b.real), (c.real, d.real)), ((a.imag, b.imag), (c.imag, d.imag))):
            if max(one) + reach < min(two) or max(two) + reach < min(one):
                return False
        return not (lies_beside(a, b, c, d, reach) or lies_beside(c, d, a, b, reach))


def lies_beside(a, b, c, d, reach):
    """Whether c and d lie farther than `reach` on one side of the line through a and b."""
    length = abs(b - a)
    if length == 0:
        return False
    one, two = polygons.side(a, b, c) / length, polygons.side(a, b, d) / length
    return min(one, two) > reach or max(one, two) < -reach


def pieces(curve, start=None, end=None):
    """The smooth pieces of a curve; `start`, `end`: points to which its ends are moved."""
    bends = curve.bends()
    points = [curve.start if start is None else start] + [curve.at(t1) for _, t1, _ in bends[:-1]]
    points.append(curve.end if end is None else end)
    return [Piece(curve, t0, t1, a, b, bend) for (t0, t1, bend), a, b in zip(bends, points, points[1:])]


def box(curve, margin=0.0):
    """Two corners of a box around the curve."""
    found = [part for piece in pieces(curve) for part in halved(piece, 3 if piece.bend else 0)]
    reach = max(piece.width for piece in found) + margin
    points = [z for piece in found for z in (piece.a, piece.b)]
    across, up = [z.real for z in points], [z.imag for z in points]
    return complex(min(across) - reach, min(up) - reach), complex(max(across) + reach, max(up) + reach)


def size(curve):
    """The diagonal of its box."""
    low, high = box(curve)
    return abs(high - low)


def halved(piece, times):
    if times == 0:
        return [piece]
    return [part for half in piece.halves() for part in halved(half, times - 1)]


def parameter_near(curve, z, distance):
    """The parameter of the curve's point nearest to z, if that is no farther than the distance, else None."""
    best, found = distance, None
    stack = pieces(curve)[::-1]
    while stack:
        piece = stack.pop()
        if piece.distance(z) > best:
            continue
        if piece.width > 1e-3 * distance and piece.t1 - piece.t0 > 1e-14 * max(abs(piece.t0), abs(piece.t1)):
            stack += sorted(piece.halves(), key=lambda half: -half.distance(z))
            continue
        along = piece.b - piece.a
        share = min(max(((z - piece.a) * along.conjugate()).real / abs(along) ** 2, 0.0), 1.0) if along else 0.0
        t = piece.t0 + share * (piece.t1 - piece.t0)
        if abs(curve.at(t) - z) <= best:
            best, found = abs(curve.at(t) - z), t
    return found


def is_crossed_by_ray(piece, z, depth=0):
    """Whether the ray from z to the right crosses the piece an odd number of times."""
    a, b, w = piece.a, piece.b, piece.width
    if max(a.real, b.real) + w < z.real or max(a.imag, b.imag) + w < z.imag or min(a.imag, b.imag) - w > z.imag:
        return False
    if min(a.real, b.real) - w > z.real:
        return (a.imag > z.imag) != (b.imag > z.imag)
    if w == 0 or depth == MOST_HALVINGS:
        return polygons.is_right_of(z, a, b)
    one, two = piece.halves()
    return is_crossed_by_ray(one, z, depth + 1) != is_crossed_by_ray(two, z, depth + 1)


def crossing(some, others, accuracy, is_excepted):
    """A point where pieces of two curves cross, up to the accuracy, and is_excepted(point) is false; else None."""
    stack = [(one, two) for one in some for two in others]
    while stack:
        one, two = stack.pop()
        if not one.may_meet(two):
            continue
        if one.width + two.width <= accuracy:
            z = crossing_of_chords(one, two)
            if z is not None and not is_excepted(z):
                return z
        elif one.width >= two.width:
            stack += [(half, two) for half in one.halves()]
        else:
            stack += [(one, half) for half in two.halves()]
    return None


def crossing_of_chords(one, two):
    a, b, c, d = one.a, one.b, two.a, two.b
    if polygons.side(a, b, c) * polygons.side(a, b, d) >= 0 or polygons.side(c, d, a) * polygons.side(c, d, b) >= 0:
        return None
    share = polygons.cross(c - a, d - c) / polygons.cross(b - a, d - c)
    return a + share * (b - a)


def area_beside(piece, count=32):
    """Between the origin and the piece: half of the integral of x dy - y dx, extrapolated from two polygons."""
    def of_polygon(n):
        step = (piece.t1 - piece.t0) / n
        points = [piece.a, *(piece.curve.at(piece.t0 + i * step) for i in range(1, n)), piece.b]
        return sum(polygons.cross(a, b) for a, b in zip(points, points[1:])) / 2

    if piece.bend == 0:
        return of_polygon(1)
    return (4 * of_polygon(2 * count) - of_polygon(count)) / 3
