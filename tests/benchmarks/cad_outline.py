"""The outline of a planar CAD face, by Gmsh's CAD kernel and numpy: what quad_judge.py compares meshes with.

Lengths are as Gmsh reads the file: in millimetres if the file is STEP. Positions are in the plane of the face: those of
the file if the plane is z = const, else in axes of its own."""
import contextlib, os, sys

import gmsh, numpy

CORNER = numpy.radians(1)  # a boundary that turns by more has a corner
GAUSS = numpy.polynomial.legendre.leggauss(8)
PIECES = 128, 1 << 15  # of an edge, for integrals: least and greatest number
SAMPLES = {"Line": 8}  # of an edge, for distances; of all other kinds 512


class Edge:
    """A boundary edge: `points` and the parameters that they belong to, ends included."""

    def __init__(self, outline, signed):
        self.tag, self.sign, self.outline = abs(signed), 1 if signed > 0 else -1, outline
        (self.low,), (self.high,) = gmsh.model.getParametrizationBounds(1, self.tag)
        self.at = numpy.linspace(self.low, self.high, SAMPLES.get(gmsh.model.getType(1, self.tag), 512) + 1)

    def space(self, at):
        return numpy.reshape(gmsh.model.getValue(1, self.tag, at), (-1, 3))

    def values(self, at):
        return self.outline.flat(self.space(at))

    def slopes(self, at):
        return numpy.reshape(gmsh.model.getDerivative(1, self.tag, at), (-1, 3)) @ self.outline.axes[:2].T

    def prepare(self):
        self.points = self.values(self.at)
        self.low_corner, self.high_corner = self.points.min(axis=0), self.points.max(axis=0)
        self.spacing = numpy.linalg.norm(numpy.diff(self.points, axis=0), axis=1).max()
        self.is_closed = numpy.linalg.norm(self.points[0] - self.points[-1]) < 1e-6 * self.spacing

    def integrals(self):
        """Twice the area that the edge contributes by Green's formula (with its direction), and its length."""
        pieces, (area, length) = PIECES[0], self.integrals_over(PIECES[0])
        while pieces < PIECES[1]:  # some splines have short spans between their knots
            pieces, before = 4 * pieces, length
            area, length = self.integrals_over(pieces)
            if abs(length - before) <= 1e-9 * length:
                break
        return area, length

    def integrals_over(self, pieces):
        step = (self.high - self.low) / pieces
        at = (self.low + step * (numpy.arange(pieces)[:, None] + (1 + GAUSS[0]) / 2)).ravel()
        x, slope, weights = self.values(at), self.slopes(at), numpy.tile(GAUSS[1], pieces) * step / 2
        cross = x[:, 0] * slope[:, 1] - x[:, 1] * slope[:, 0]
        return self.sign * float(weights @ cross), float(weights @ numpy.linalg.norm(slope, axis=1))

    def ends(self):
        """((start, direction), (end, direction)), along the boundary."""
        step = 1e-6 * (self.high - self.low)
        x = self.values(numpy.array([self.low, self.low + step, self.high - step, self.high]))
        x = x if self.sign > 0 else x[::-1]
        return (x[0], x[1] - x[0]), (x[3], x[3] - x[2])

    def box_distances(self, points):
        """A lower bound of the distance from each point to the edge's samples."""
        outside = numpy.maximum(numpy.maximum(self.low_corner - points, points - self.high_corner), 0)
        return numpy.linalg.norm(outside, axis=1)

    def nearest_samples(self, points):
        """For each point the distance to the nearest sample, and its parameter."""
        squared, nearest = numpy.empty(len(points)), numpy.empty(len(points), dtype=int)
        for part in numpy.array_split(numpy.arange(len(points)), 1 + len(points) // 1000):
            away = ((points[part][:, None] - self.points[None]) ** 2).sum(axis=2)
            nearest[part] = away.argmin(axis=1)
            squared[part] = away.min(axis=1)
        return numpy.sqrt(squared), self.at[nearest]

    def project(self, points, at):
        """Distances to the edge near the parameters `at`, by Gauss and Newton's method. Both ends of a closed edge are
        the nearest sample of points beside its seam: the method goes on across it."""
        least = numpy.linalg.norm(self.values(at) - points, axis=1)
        for _ in range(20):
            x, slope = self.values(at) - points, self.slopes(at)
            squared = numpy.maximum((slope**2).sum(axis=1), 1e-300)
            at = at - (x * slope).sum(axis=1) / squared
            if self.is_closed:
                at = self.low + (at - self.low) % (self.high - self.low)
            at = numpy.clip(at, self.low, self.high)
            least = numpy.minimum(least, numpy.linalg.norm(self.values(at) - points, axis=1))
        return least


@contextlib.contextmanager
def stdout_to_stderr():
    """For OpenCASCADE, which prints what it reads of IGES files."""
    sys.stdout.flush()
    kept = os.dup(1)
    os.dup2(2, 1)
    try:
        yield
    finally:
        os.dup2(kept, 1)
        os.close(kept)


def angle(a, b):
    return abs(numpy.arctan2(a[0] * b[1] - a[1] * b[0], a @ b))


class Outline:
    """`edges`, `loops` (their number), `area`, `perimeter`, `diameter`, `corners` [n, 2]. Raises ValueError if the file
    holds no single planar face."""

    def __init__(self, path):
        gmsh.clear()
        gmsh.model.add("cad")
        self.model = gmsh.model.getCurrent()
        try:
            with stdout_to_stderr():
                gmsh.model.occ.importShapes(str(path))
            gmsh.model.occ.synchronize()
        except Exception as failure:
            raise ValueError(f"Gmsh cannot read it: {failure}") from failure
        faces = gmsh.model.getEntities(2)
        if len(faces) != 1 or gmsh.model.getEntities(3):
            raise ValueError(f"{len(faces)} faces instead of one")
        self.edges = [Edge(self, signed) for _, signed in gmsh.model.getBoundary(faces, oriented=True)]
        self.set_plane(numpy.concatenate([edge.space(edge.at) for edge in self.edges]))
        for edge in self.edges:
            edge.prepare()
        points = numpy.concatenate([edge.points for edge in self.edges])
        self.low, self.high = points.min(axis=0), points.max(axis=0)
        few = points[:: 1 + len(points) // 4000]
        self.diameter = max(numpy.linalg.norm(few - p, axis=1).max() for p in few)
        self.measure()

    def set_plane(self, points):
        middle = points.mean(axis=0)
        _, extents, axes = numpy.linalg.svd(points - middle, full_matrices=False)
        if extents[2] > 1e-6 * extents[0]:
            raise ValueError("the face is not planar")
        if abs(axes[2, 2]) > 1 - 1e-12:
            self.origin, self.axes = numpy.array([0, 0, middle[2]]), numpy.eye(3)
        else:
            self.origin, self.axes = middle, numpy.array([axes[0], axes[1], numpy.cross(axes[0], axes[1])])

    def flat(self, points):
        """[n, 3] in space to [n, 2] in the plane."""
        return (points - self.origin) @ self.axes[:2].T

    def height(self, points):
        """Signed distance from the plane."""
        return (points - self.origin) @ self.axes[2]

    def measure(self):
        ends = [edge.ends() for edge in self.edges]
        starts = numpy.array([start for (start, _), _ in ends])
        loops, followers, self.corners, self.perimeter = [], set(), [], 0.0  # a loop: twice its area, the numbers of its edges
        for number, (edge, (_, (end, into))) in enumerate(zip(self.edges, ends)):
            twice_area, length = edge.integrals()
            self.perimeter += length
            following = int(((starts - end) ** 2).sum(axis=1).argmin())
            followers.add(following)
            if angle(into, ends[following][0][1]) > CORNER:
                self.corners.append(end)
            merged = [twice_area, {number, following}]
            for loop in [loop for loop in loops if loop[1] & merged[1]]:
                merged = [merged[0] + loop[0], merged[1] | loop[1]]
            loops = [loop for loop in loops if not loop[1] & merged[1]] + [merged]
        if len(followers) != len(self.edges):
            raise ValueError("the boundary touches itself, or is open")
        areas = sorted(abs(loop[0]) / 2 for loop in loops)
        self.loops, self.area = len(loops), areas[-1] - sum(areas[:-1])
        self.corners = numpy.reshape(self.corners, (-1, 2))

    def distances(self, points):
        """From each point of the plane to the outline."""
        gmsh.model.setCurrent(self.model)
        least, seen = numpy.full(len(points), numpy.inf), []
        for edge in self.edges:
            near = numpy.flatnonzero(edge.box_distances(points) <= least)
            away, at = edge.nearest_samples(points[near])
            least[near] = numpy.minimum(least[near], away)
            seen.append((edge, near, away, at))
        result = least.copy()
        for edge, near, away, at in seen:
            candidates = away <= least[near] + edge.spacing
            if candidates.any():
                found = edge.project(points[near[candidates]], at[candidates])
                result[near[candidates]] = numpy.minimum(result[near[candidates]], found)
        return result
