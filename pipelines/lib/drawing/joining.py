"""From the curves of a drawing to a planar graph: edges that end at common vertices. Ends within the tolerance are one
vertex; a vertex on a curve divides it; curves that lie upon others are kept once. Curves that cross, and ends that
meet no other, are refused."""
import math
from collections import Counter
from dataclasses import dataclass, replace

from drawing import pieces
from drawing.curves import Ellipse, Segment
from drawing.sketch import listed, place
from outline.box_tree import BoxTree

DEFAULT_TOLERANCE = 1e-5  # diagonals of the box around the drawing
LARGEST_JOIN = 0.003      # of them: arcs and splines are moved by cad2tri, and no further than about this
LEAST_NOTED = 0.01        # tolerances: moves of ends that are mentioned
MOST_GAPS = 5             # that a message names
MOST_LOOSE = 100          # loose ends whose gaps are measured


@dataclass(frozen=True, eq=False)
class Edge:
    """A curve between two vertices, points at which its ends are at most the tolerance away. `upon`: names of others
    that lie upon it."""

    curve: object
    entity: object
    start: complex
    end: complex
    upon: frozenset = frozenset()

    @property
    def name(self):
        return self.entity.name

    @property
    def label(self):
        return self.entity.label

    def pieces(self):
        return pieces.pieces(self.curve, self.start, self.end)

    @property
    def middle(self):
        return self.at(0.5)

    def at(self, share):
        t0, t1 = self.curve.range
        return self.curve.at(t0 + share * (t1 - t0))


def diagonal(entities):
    """Of the box around all curves."""
    boxes = [pieces.box(entity.curve) for entity in entities]
    return abs(complex(max(b.real for _, b in boxes) - min(a.real for a, _ in boxes),
                       max(b.imag for _, b in boxes) - min(a.imag for a, _ in boxes)))


# ---- vertices


class Clusters:
    """Groups of points, each within the tolerance of another one of its group."""

    def __init__(self, points, tolerance):
        self.parent = list(range(len(points)))
        cells = {}
        for i, z in enumerate(points):
            column, row = math.floor(z.real / tolerance), math.floor(z.imag / tolerance)
            for x in (column - 1, column, column + 1):
                for y in (row - 1, row, row + 1):
                    for k in cells.get((x, y), ()):
                        if abs(points[k] - z) <= tolerance:
                            self.parent[self.first(i)] = self.first(k)
            cells.setdefault((column, row), []).append(i)

    def first(self, i):
        while self.parent[i] != i:
            self.parent[i] = self.parent[self.parent[i]]
            i = self.parent[i]
        return i


def vertices_of(entities, tolerance):
    """The vertex of each end, start and end of each entity in turn: the first end there that is no line's, which can
    turn, else the first."""
    ends = [z for entity in entities for z in (entity.curve.start, entity.curve.end)]
    clusters = Clusters(ends, tolerance)
    chosen = {}
    for wants_line in (False, True):
        for i, z in enumerate(ends):
            if isinstance(entities[i // 2].curve, Segment) == wants_line:
                chosen.setdefault(clusters.first(i), z)
    return [chosen[clusters.first(i)] for i in range(len(ends))]


def is_short(entity, tolerance):
    return pieces.size(entity.curve) <= tolerance


def edges_of(sketch, tolerance):
    """The entities as edges between vertices, but for those that are shorter than the tolerance."""
    short = [entity for entity in sketch.entities if is_short(entity, tolerance)]
    if short:
        sketch.warnings.append(("W-DRW-001", f"left out, as no longer than {tolerance:.3g} {sketch.unit}: " +
                                listed([f"{entity.label} at {place(entity.curve.start)}" for entity in short])))
    kept = [entity for entity in sketch.entities if not is_short(entity, tolerance)]
    if not kept:
        raise sketch.fault(f"no curve is longer than the tolerance, {tolerance:.3g}: lower it (--drawing-tolerance)")
    vertices = vertices_of(kept, tolerance)
    note_moves(sketch, [z for entity in kept for z in (entity.curve.start, entity.curve.end)], vertices, tolerance)
    return [edge_between(entity.curve, entity, *vertices[2 * i : 2 * i + 2])
            for i, entity in enumerate(kept)]


def note_moves(sketch, ends, vertices, tolerance):
    move, vertex = max(((abs(z - vertex), vertex) for z, vertex in zip(ends, vertices)), key=lambda found: found[0])
    if move > LEAST_NOTED * tolerance:
        sketch.notes.append(f"ends up to {move:.3g} {sketch.unit} apart are joined, most at {place(vertex)}")


def edge_between(curve, entity, start, end):
    """Lines run from vertex to vertex."""
    return Edge(Segment(start, end) if isinstance(curve, Segment) else curve, entity, start, end)


# ---- what lies near what


def tree_of(boxes):
    """A tree of boxes, along a curve that fills the plane, and their order in it."""
    middles = [(a + b) / 2 for a, b in boxes]
    low = complex(min(z.real for z in middles), min(z.imag for z in middles))
    size = max(max(z.real for z in middles) - low.real, max(z.imag for z in middles) - low.imag) or 1.0

    def rank(i):
        x, y = (int(1023 * value / size) for value in ((middles[i] - low).real, (middles[i] - low).imag))
        return sum(((x >> bit & 1) << 2 * bit) + ((y >> bit & 1) << 2 * bit + 1) for bit in range(10))

    order = sorted(range(len(boxes)), key=rank)
    return BoxTree([boxes[i] for i in order]), order


def near_pairs(boxes):
    """Pairs i < k of boxes that meet, in order."""
    tree, order = tree_of(boxes)
    return sorted(tuple(sorted((order[i], order[k]))) for i, k in tree.near_pairs(0.0))


def boxes_of(edges, tolerance):
    return [pieces.box(edge.curve, tolerance) for edge in edges]


def divided(edges, tolerance):
    """The edges, those divided on which vertices of others lie."""
    degrees = Counter(z for edge in edges for z in (edge.start, edge.end))
    vertices, found = list(degrees), {}  # found: of each edge (parameter, vertex)
    for i, k in near_pairs(boxes_of(edges, tolerance) + [(z, z) for z in vertices]):
        if i >= len(edges) or k < len(edges):
            continue
        edge, z = edges[i], vertices[k - len(edges)]
        t = None if z in (edge.start, edge.end) else pieces.parameter_near(edge.curve, z, tolerance)
        if t is not None:
            found.setdefault(i, []).append((t, z))
    return [part for i, edge in enumerate(edges)
            for part in parts_of(edge, sorted(found.get(i, []), key=lambda cut: cut[0]), degrees[edge.start] == 2)]


def parts_of(edge, cuts, is_alone):
    """`is_alone`: no other edge begins where this one does; a whole ellipse is then cut elsewhere only."""
    if not cuts:
        return [edge]
    (t0, t1), curve = edge.curve.range, edge.curve
    marks = [(t0, edge.start), *cuts, (t1, edge.end)]
    if is_alone and isinstance(curve, Ellipse) and curve.is_whole:
        marks = [*cuts, (cuts[0][0] + t1 - t0, cuts[0][1])]
    return [edge_between(curve.part(a, b), edge.entity, start, end)
            for (a, start), (b, end) in zip(marks, marks[1:])]


def lies_upon(edge, other, tolerance):
    return {edge.start, edge.end} == {other.start, other.end} and all(
        pieces.parameter_near(other.curve, edge.at(share), tolerance) is not None for share in (0.25, 0.5, 0.75))


def kept_once(edges, tolerance, warnings):
    """Without edges that lie upon earlier ones."""
    kept, between, repeated = [], {}, []
    for edge in edges:
        rivals = between.setdefault(frozenset((edge.start, edge.end)), [])
        first = next((i for i in rivals if lies_upon(edge, kept[i], tolerance)), None)
        if first is not None:
            repeated.append(f"{edge.label} on {kept[first].label} at {place(edge.middle)}")
            kept[first] = replace(kept[first], upon=kept[first].upon | {edge.name})
        else:
            rivals.append(len(kept))
            kept.append(edge)
    if repeated:
        warnings.append(("W-DRW-002", f"kept once, although drawn several times: {listed(repeated)}"))
    return kept


# ---- what is refused


def refuse_crossings(sketch, edges, tolerance):
    boxes, found = boxes_of(edges, 0.0), [edge.pieces() for edge in edges]
    for i, k in near_pairs(boxes):
        one, two = edges[i], edges[k]
        z = pieces.crossing(found[i], found[k], tolerance / 10,
                            lambda z, one=one, two=two: is_at_joint(z, one, two, tolerance))
        if z is not None:
            raise sketch.fault(f"{one.label} crosses {two.label} at {place(z)}: trim them where they meet, or leave "
                               "out a layer (--drawing-layers)")
    for edge, own in zip(edges, found):
        if not isinstance(edge.curve, (Segment, Ellipse)):
            refuse_own_crossing(sketch, edge, own, tolerance)


def is_at_joint(z, one, two, tolerance):
    """Whether the edges, which meet at z, lie upon each other from there to a common vertex."""
    middles = [(z + vertex) / 2 for vertex in {one.start, one.end} & {two.start, two.end}]
    return any(all(pieces.parameter_near(edge.curve, middle, tolerance) is not None for edge in (one, two))
               for middle in middles)


def refuse_own_crossing(sketch, edge, own, tolerance):
    parts = [part for piece in own for part in pieces.halved(piece, 2)]
    for i, piece in enumerate(parts):
        z = pieces.crossing([piece], parts[i + 2 :], tolerance / 10, lambda z: abs(z - edge.start) <= 4 * tolerance)
        if z is not None:
            raise sketch.fault(f"{edge.label} crosses itself at {place(z)}: divide it into curves that do not")


@dataclass(frozen=True)
class Gap:
    size: float
    vertex: complex
    edge: Edge
    other: Edge


def refuse_gaps(sketch, edges, size):
    """`size`: of the drawing."""
    degrees = Counter(z for edge in edges for z in (edge.start, edge.end))
    loose = [(z, edge) for edge in edges for z in (edge.start, edge.end) if degrees[z] == 1]
    if not loose:
        return
    gaps = sorted((gap_at(z, edge, edges, loose) for z, edge in loose[:MOST_LOOSE]), key=lambda gap: gap.size)
    once = {(frozenset((gap.edge, gap.other)), f"{gap.size:.6g}"): gap for gap in reversed(gaps)}  # it has two sides
    raise sketch.fault(gap_sentence(list(once.values())[::-1], sketch.unit, size))


def gap_at(vertex, edge, edges, loose):
    """To the nearest loose end, or curve, of another edge that does not begin here."""
    others = [(abs(z - vertex), other) for z, other in loose if z != vertex and other is not edge]
    size, nearest = min(others, key=lambda found: found[0], default=(math.inf, None))
    for other in edges:
        if vertex in (other.start, other.end) or other is edge:
            continue
        t = pieces.parameter_near(other.curve, vertex, min(size, abs(vertex - other.start)))
        if t is not None and abs(other.curve.at(t) - vertex) < size:
            size, nearest = abs(other.curve.at(t) - vertex), other
    return Gap(size, vertex, edge, nearest)


def rounded_up(x):
    """By 2 % or more, with two digits."""
    unit = 10.0 ** (math.floor(math.log10(1.02 * x)) - 1)
    return math.ceil(1.02 * x / unit) * unit


def gap_sentence(gaps, unit, size):
    """`size`: of the drawing."""
    gap = gaps[0]
    if gap.other is None:
        return f"{gap.edge.label} ends at {place(gap.vertex)}, and there is no other curve: close it in the drawing"
    remedy = "close it in the drawing, "
    if gap.size <= LARGEST_JOIN * size:
        remedy += f"join what is as near by --drawing-tolerance {rounded_up(gap.size):.2g}, "
    more = listed([f"{gap.size:.3g} {unit} at {place(gap.vertex)}, {gap.edge.label}" for gap in gaps[1:]], MOST_GAPS)
    return (f"a gap of {gap.size:.3g} {unit} at {place(gap.vertex)}: {gap.edge.label} ends {gap.size:.3g} {unit} from "
            f"{gap.other.label}: {remedy}leave its layer out (--drawing-layers) or embed it (--embed)"
            + (f". More gaps: {more}" if more else ""))
