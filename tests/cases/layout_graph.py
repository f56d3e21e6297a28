"""x.sep.json for tests: its nodes and arcs as geometry, and how far two layouts are apart as graphs.

Positions are those of the file's unit with the face's origin added, as complex numbers. A motion is a function of them.
Nothing here is shared with the library that is tested."""
import bisect, cmath, collections, functools, json, math

SAMPLES = 12  # of each knot span, to find the nearest one before refining
SHARES = (0.1, 0.3, 0.5, 0.7, 0.9)  # of the way along an arc, where arcs are compared


class Curve:
    """A NURBS, evaluated by de Boor's algorithm in homogeneous coordinates."""

    def __init__(self, entry, origin):
        self.degree, self.knots = entry["degree"], entry["knots"]
        self.poles = [((complex(*pole) + origin) * weight, weight) for pole, weight in zip(entry["poles"], entry["weights"])]
        self.breaks = sorted(set(self.knots[self.degree : len(self.knots) - self.degree]))

    def __call__(self, t):
        degree, knots = self.degree, self.knots
        span = min(max(bisect.bisect_right(knots, t) - 1, degree), len(self.poles) - 1)
        local = self.poles[span - degree : span + 1]
        for level in range(1, degree + 1):
            for i in range(degree, level - 1, -1):
                left, right = knots[span - degree + i], knots[span + 1 + i - level]
                share = (t - left) / (right - left)
                local[i] = tuple((1 - share) * a + share * b for a, b in zip(local[i - 1], local[i]))
        point, weight = local[degree]
        return point / weight


class Path:
    """A chain of pieces [curve, t0, t1]; its parameter runs from 0 to their number."""

    def __init__(self, pieces):
        self.pieces = pieces

    def __call__(self, s):
        number = min(int(s), len(self.pieces) - 1)
        curve, t0, t1 = self.pieces[number]
        return curve(t0 + (s - number) * (t1 - t0))

    @functools.cached_property
    def samples(self):
        """(s, point) along the path, some in every knot span."""
        values = []
        for number, (curve, t0, t1) in enumerate(self.pieces):
            low, high = min(t0, t1), max(t0, t1)
            inside = [low, *(t for t in curve.breaks if low < t < high), high]
            parameters = [a + (b - a) * k / SAMPLES for a, b in zip(inside, inside[1:]) for k in range(SAMPLES)] + [high]
            values += [number + (t - t0) / (t1 - t0) for t in parameters]
        return [(s, self(s)) for s in sorted(set(values))]

    def rough_distance(self, point):
        """To the nearest sample."""
        return min(abs(sample - point) for _, sample in self.samples)

    def distance(self, point):
        """From the point to the path: Newton's method from the nearest sample, to round-off where the point is near."""
        at = min(range(len(self.samples)), key=lambda k: abs(self.samples[k][1] - point))
        low, high = self.samples[max(at - 1, 0)][0], self.samples[min(at + 1, len(self.samples) - 1)][0]
        s, nearest = self.samples[at]
        best, step = abs(nearest - point), 1e-5
        for _ in range(8):
            left, right = max(s - step, 0), min(s + step, len(self.pieces))
            slope = (self(right) - self(left)) / (right - left)
            change = ((point - self(s)) * slope.conjugate()).real / abs(slope) ** 2
            s = min(max(s + change, low), high)
            best = min(best, abs(self(s) - point))
            if abs(change) < 1e-14:
                break
        return best


Node = collections.namedtuple("Node", "kind valence position")
Arc = collections.namedtuple("Arc", "start end is_boundary path")


class Graph:
    def __init__(self, path):
        content = json.load(open(path, encoding="utf-8"))
        face = content["face"]
        origin = complex(*face["origin"])
        self.origin, self.diameter = origin, face["diameter"]
        curves = [Curve(entry, origin) for entry in face["curves"] + content["splines"]]
        self.outline = [Path([(curve, curve.breaks[0], curve.breaks[-1])]) for curve in curves[: len(face["curves"])]]
        self.loop_offsets = face["loop_offsets"]
        self.nodes = [Node(n["kind"], n["valence"], complex(*n["position"]) + origin) for n in content["nodes"]]
        self.arcs = [
            Arc(a["from"], a["to"], a["is_boundary"], Path([(curves[p["curve"]], p["t0"], p["t1"]) for p in a["pieces"]]))
            for a in content["arcs"]
        ]


class Differs(Exception):
    """The two are not one graph; says where."""


def place(z):
    return f"({z.real:.6g}, {z.imag:.6g})"


def match_nodes(first, second, motion):
    """For each node of the first the node of the second, nearest first, and the greatest distance."""
    counts = [collections.Counter(node[:2] for node in graph.nodes) for graph in (first, second)]
    if counts[0] != counts[1]:
        more = ", ".join(f"{n} {kind} V={valence}" for (kind, valence), n in sorted((counts[0] - counts[1]).items()))
        less = ", ".join(f"{n} {kind} V={valence}" for (kind, valence), n in sorted((counts[1] - counts[0]).items()))
        raise Differs(f"nodes: first has {more or 'none'} more, second {less or 'none'}")
    moved = [motion(node.position) for node in first.nodes]
    pairs = sorted(
        (abs(moved[i] - second.nodes[j].position), i, j)
        for i in range(len(moved))
        for j in range(len(moved))
        if first.nodes[i][:2] == second.nodes[j][:2]
    )
    partner, taken, farthest = {}, set(), (0.0, "")
    for distance, i, j in pairs:
        if i not in partner and j not in taken:
            partner[i] = j
            taken.add(j)
            farthest = max(farthest, (distance, f"{first.nodes[i].kind} node at {place(second.nodes[j].position)}"))
    return partner, farthest


def off(arc, other, motion):
    """How far points inside the first arc, moved, are from the second one."""
    return max(other.path.distance(motion(arc.path(len(arc.path.pieces) * share))) for share in SHARES)


def apart(first, second, motion=lambda z: z):
    """(greatest distance between nodes and arcs, its place) of the first graph, moved, and the second, in units of
    length. Throws Differs where nodes (kind, valence) or arcs (their ends) do not correspond one to one. Nodes that
    are matched from farther than a tenth of the diameter count as different, too."""
    partner, farthest = match_nodes(first, second, motion)
    if farthest[0] > 0.1 * second.diameter:
        raise Differs(f"no partner near for the {farthest[1]}")
    left = collections.defaultdict(list)
    for arc in second.arcs:
        left[min(arc.start, arc.end), max(arc.start, arc.end), arc.is_boundary].append(arc)
    for arc in first.arcs:
        ends = sorted((partner[arc.start], partner[arc.end]))
        candidates = left[ends[0], ends[1], arc.is_boundary]
        if not candidates:
            names = " and ".join(f"{second.nodes[n].kind} {place(second.nodes[n].position)}" for n in ends)
            raise Differs(f"arcs: none between {names} in the second")
        distances = [off(arc, other, motion) for other in candidates]
        best = distances.index(min(distances))
        candidates.pop(best)
        middle = motion(arc.path(len(arc.path.pieces) / 2))
        farthest = max(farthest, (distances[best], f"{'boundary ' * arc.is_boundary}arc by {place(middle)}"))
    if any(left.values()):
        raise Differs(f"arcs: {sum(map(len, left.values()))} more in the second")
    return farthest


def motion(mirror=False, rotate=0.0, scale=1.0, move=(0.0, 0.0)):
    """As tests/data/move_step.py moves shapes: mirrored in the x-axis, turned (degrees) about 0, scaled, moved."""
    factor = scale * cmath.exp(1j * math.radians(rotate))
    return lambda z: factor * (z.conjugate() if mirror else z) + complex(*move)
