"""The triangle mesh of a field: maps of its elements and their inverses (formats/tri-mesh.md)."""
import numpy as np

from . import reference
from .face import Face
from .stage_result import StageResult

INSIDE = 1e-10  # points this far outside of a reference triangle, in barycentric coordinates, count as inside
PAIRS_AT_ONCE = 20000


class TriMesh(StageResult):
    """Triangles, some of them curved.

    `face`: Face; `vertices` [n, 2]; `elem2vertices` [m, 3]; `order` of the curved elements; `boundary_edges`: a dict of
    arrays `elem`, `edge`, `curve`, `t0`, `t1`; `elem_region` [m]: the number of the region of each triangle.
    """

    def __init__(self, content):
        self.face = Face(content["face"])
        self.order = int(content["order"])
        self.vertices = np.asarray(content["vertices"], float) + self.face.origin
        self.elem2vertices = np.asarray(content["elem2vertices"])
        self.boundary_edges = dict(content["boundary_edges"])
        self.curved_elems = np.asarray(content["curved_elems"])
        shape = (len(self.curved_elems), reference.num_modes(self.order), 2)
        nodes = np.asarray(content["curved_nodes"], float).reshape(shape) + self.face.origin
        self._coefficients = np.einsum("mn,enk->emk", reference.tri_fit(self.order), nodes)
        self._curved_row = np.full(self.num_elements, -1)
        self._curved_row[self.curved_elems] = np.arange(len(self.curved_elems))
        offsets = np.asarray(content.get("region_elems", [0, self.num_elements]))
        self.elem_region = np.repeat(np.arange(len(offsets) - 1), np.diff(offsets))
        self._make_grid()

    def summary(self):
        return f"{self.num_elements} triangles of order {self.order}, {len(self.face.curves)} curves"

    @property
    def num_elements(self):
        return len(self.elem2vertices)

    def map(self, elem, xi):
        """Positions [n, 2] and derivatives [n, 2, 2] (row: x or y) of the maps of elements [n] at xi [n, 2]."""
        corners = self.vertices[self.elem2vertices[elem]]
        half = np.stack([corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]], axis=-1) / 2
        x = corners[:, 0] + np.einsum("nij,nj->ni", half, xi + 1)
        curved = np.flatnonzero(self._curved_row[elem] >= 0)
        for part in chunks(curved):
            rows = self._curved_row[elem[part]]
            x[part], half[part] = reference.sum_modes(self._coefficients[rows], xi[part])
        return x, half

    def locate(self, points, tolerance=1e-12):
        """The element of each point [n], -1 outside the mesh, and the reference positions xi [n, 2] there.

        A point in several elements is in the one with the lowest number. Points at most `tolerance` diameters of the
        face outside the mesh belong to the nearest element: raise it for points of the CAD curves, from which the
        curved edges deviate a little.
        """
        points = np.asarray(points, float).reshape(-1, 2)
        point, elem = self._candidates(points)
        xi, found = self._invert(elem, points[point])
        outside = np.max([-(1 + xi[:, 0]), -(1 + xi[:, 1]), xi.sum(axis=1)], axis=0) / 2
        distance = np.where(outside <= INSIDE, 0, outside * self._sizes[elem])
        fits = np.flatnonzero(found & (distance <= tolerance * self.face.diameter))
        fits = fits[np.lexsort((elem[fits], distance[fits], point[fits]))]
        first = fits[np.unique(point[fits], return_index=True)[1]]
        result, position = np.full(len(points), -1), np.full(points.shape, np.nan)
        result[point[first]], position[point[first]] = elem[first], xi[first]
        return result, position

    def _invert(self, elem, x):
        """xi with map(elem, xi) = x by Newton's method with short steps, and where it converged."""
        corners = self.vertices[self.elem2vertices[elem]]
        half = np.stack([corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]], axis=-1) / 2
        xi = solve2(half, x - corners[:, 0]) - 1
        found = self._curved_row[elem] < 0
        active = np.flatnonzero(~found)
        xi[active] = np.clip(xi[active], -1, 1)
        for _ in range(40):
            if not len(active):
                break
            position, derivative = self.map(elem[active], xi[active])
            step = solve2(derivative, x[active] - position)
            length = np.linalg.norm(step, axis=1)
            xi[active] = np.clip(xi[active] + step * np.minimum(1, 0.7 / np.maximum(length, 1e-300))[:, None], -2, 2)
            found[active] = length < 1e-12
            active = active[~(length < 1e-12)]
        return xi, found

    def _make_grid(self):
        """Boxes about the elements, with a margin, and for each cell of a grid the elements whose box touches it."""
        r = np.linspace(-1, 1, 4 * self.order + 1)[:, None]
        edges = np.concatenate([(a * (1 - r) + b * (1 + r)) / 2
                                for a, b in zip(reference.TRIANGLE, np.roll(reference.TRIANGLE, -1, axis=0))])
        elem = np.repeat(np.arange(self.num_elements), len(edges))
        outline = self.map(elem, np.tile(edges, (self.num_elements, 1)))[0].reshape(self.num_elements, -1, 2)
        lower, upper = outline.min(axis=1), outline.max(axis=1)
        self._sizes = np.max(upper - lower, axis=1)
        self._lower, self._upper = lower - self._sizes[:, None] / 10, upper + self._sizes[:, None] / 10
        self._corner = self._lower.min(axis=0)
        self._num_cells = int(np.ceil(2 * np.sqrt(self.num_elements)))
        self._cell = (self._upper.max(axis=0) - self._corner) / self._num_cells
        first, last = self._cell_of(self._lower), self._cell_of(self._upper)
        pairs = [(i * self._num_cells + j, e) for e in range(self.num_elements)
                 for i in range(first[e, 0], last[e, 0] + 1) for j in range(first[e, 1], last[e, 1] + 1)]
        pairs = np.array(sorted(pairs))
        self._cell_elems = pairs[:, 1]
        self._cell_offsets = np.searchsorted(pairs[:, 0], np.arange(self._num_cells ** 2 + 1))

    def _cell_of(self, x):
        return np.clip((x - self._corner) // self._cell, 0, self._num_cells - 1).astype(int)

    def _candidates(self, points):
        """Pairs of points and elements whose box holds them."""
        usable = np.flatnonzero(np.isfinite(points).all(axis=1))
        cell = self._cell_of(points[usable]) @ [self._num_cells, 1]
        count = self._cell_offsets[cell + 1] - self._cell_offsets[cell]
        start = np.repeat(self._cell_offsets[cell] - np.concatenate([[0], np.cumsum(count)[:-1]]), count)
        point = np.repeat(usable, count)
        elem = self._cell_elems[start + np.arange(len(point))]
        x = points[point]
        inside = np.all((self._lower[elem] <= x) & (x <= self._upper[elem]), axis=1)
        return point[inside], elem[inside]


def solve2(matrix, right):
    """Solutions of systems of two equations [n, 2, 2] x = [n, 2]; not finite where the matrix is singular."""
    (a, b), (c, d) = np.moveaxis(matrix, 0, -1)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.stack([d * right[:, 0] - b * right[:, 1], a * right[:, 1] - c * right[:, 0]], axis=1) / \
            (a * d - b * c)[:, None]


def chunks(indices):
    """`indices` in parts that keep temporary arrays small."""
    return [indices[i:i + PAIRS_AT_ONCE] for i in range(0, len(indices), PAIRS_AT_ONCE)]
