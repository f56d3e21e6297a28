"""The guiding field, evaluated at points (formats/field.md, "Conventions")."""
import numpy as np

from . import reference
from .stage_file import records
from .stage_result import StageResult
from .tri_mesh import TriMesh, chunks


class Field(StageResult):
    """The guiding field (u, v) = (cos 4 psi, sin 4 psi) times its length, psi the angle of the cross.

    `kind`: "harmonic" or "phase" (a unit field); `method`: "cg" or "dg"; `mesh`: TriMesh; `face`: Face; `elem_order`:
    order of each element; `elem_error`: its estimated error, may be empty. Points are [n, 2] in the plane of the CAD
    file. Results are nan outside the mesh.
    """

    def __init__(self, content):
        self.kind, self.method = content["kind"], content["method"]
        self.mesh = TriMesh(content["mesh"])
        self.face = self.mesh.face
        self.elem_order = np.asarray(content["elem_order"])
        self.elem_error = np.asarray(content.get("elem_error", []), float)
        self._offsets = np.asarray(content["coef_offsets"])
        if self.kind == "phase":
            phases = content.get("region_phases") or {"0": content["phase"]}
            phases = [phases[str(r)] for r in range(len(phases))]
            self._coefficients = np.concatenate([np.asarray(phase["s"], float) for phase in phases])[:, None]
            self._terms = [self._terms_of_phase(phase["terms"]) for phase in phases]
        else:
            self._coefficients = np.column_stack([content["u"], content["v"]])
            liftings = records(content["liftings"])
            self._terms = [([], self._angles([l for l in liftings if l["joint"] in self.face.region_curves(r)], "jump"))
                           for r in range(len(self.face.regions))]

    def summary(self):
        least, most = min(self.elem_order), max(self.elem_order)
        return f"{self.kind}, {self.mesh.num_elements} triangles, field orders {least} to {most}"

    def _terms_of_phase(self, terms):
        points = [(np.asarray(r["position"]) + self.face.origin, np.array([r["turns"]], float))
                  for key in ("nodes", "holes", "images") for r in records(terms[key])]
        return points, self._angles(records(terms["corner_angles"]), "beta")

    def _angles(self, list_of_records, factor):
        origin = self.face.origin
        return [(np.asarray(r["apex"]) + origin, np.asarray(r["pole"]) + origin, np.atleast_1d(r[factor]))
                for r in list_of_records]

    def sample(self, points, tolerance=1e-12):
        """Values (u, v) [n, 2] and gradients [n, 2, 2] (rows u, v; columns x, y) at points [n, 2].

        `tolerance`: see TriMesh.locate. At the apex of a corner the value is the limit from inside the element, and the
        gradient has no limit.
        """
        points = np.asarray(points, float).reshape(-1, 2)
        elem, xi = self.mesh.locate(points, tolerance)
        value, gradient = np.full((len(points), 2), np.nan), np.full((len(points), 2, 2), np.nan)
        for order in np.unique(self.elem_order[elem[elem >= 0]]):
            for part in chunks(np.flatnonzero((elem >= 0) & (self.elem_order[elem] == order))):
                value[part], gradient[part] = self._sample_order(order, elem[part], xi[part], points[part])
        return value, gradient

    def value(self, points, tolerance=1e-12):
        """Values (u, v) [n, 2]."""
        return self.sample(points, tolerance)[0]

    def gradient(self, points, tolerance=1e-12):
        """Gradients [n, 2, 2]: rows u, v; columns x, y."""
        return self.sample(points, tolerance)[1]

    def cross_angle(self, points, tolerance=1e-12):
        """Angle psi of the cross [n], radians in [-pi/4, pi/4]; the others are psi + k pi / 2."""
        value = self.value(points, tolerance)
        return np.arctan2(value[:, 1], value[:, 0]) / 4

    def cross_directions(self, points, tolerance=1e-12):
        """The four unit vectors of the cross [n, 4, 2], counter-clockwise from psi."""
        angle = self.cross_angle(points, tolerance)[:, None] + np.arange(4) * np.pi / 2
        return np.stack([np.cos(angle), np.sin(angle)], axis=-1)

    def _sample_order(self, order, elem, xi, x):
        rows = self._offsets[elem][:, None] + np.arange(reference.num_modes(order))
        value, by_xi = reference.sum_modes(self._coefficients[rows], xi)
        gradient = by_xi @ np.linalg.inv(self.mesh.map(elem, xi)[1])
        inward = self.mesh.map(elem, np.full(xi.shape, -1 / 3))[0] - x
        region = self.mesh.elem_region[elem]
        for r in np.unique(region):  # the terms of a region hold in it only
            part = np.flatnonzero(region == r)
            self._add_terms(self._terms[r], x[part], inward[part], value, gradient, part)
        return self._unit_field(value[:, 0], gradient[:, 0]) if self.kind == "phase" else (value, gradient)

    @staticmethod
    def _add_terms(terms, x, inward, value, gradient, part):
        points, angles = terms
        for position, turns in points:
            value[part] += turns * _argument(x - position)[:, None]
            gradient[part] += turns[:, None] * _argument_gradient(x - position)[:, None, :]
        for apex, pole, factor in angles:
            angle, slope = _corner_angle(x, apex, pole, inward)
            value[part] += factor * angle[:, None]
            gradient[part] += factor[:, None] * slope[:, None, :]

    @staticmethod
    def _unit_field(phase, gradient):
        value = np.stack([np.cos(phase), np.sin(phase)], axis=-1)
        turned = np.stack([-value[:, 1], value[:, 0]], axis=-1)
        return value, turned[:, :, None] * gradient[:, None, :]


def _argument(z):
    """Angle of vectors [n, 2]; nan for the vector 0."""
    return np.where(np.any(z != 0, axis=1), np.arctan2(z[:, 1], z[:, 0]), np.nan)


def _argument_gradient(z):
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.stack([-z[:, 1], z[:, 0]], axis=1) / np.sum(z * z, axis=1)[:, None]


def _corner_angle(x, apex, pole, inward):
    """Arg((x - apex) / (x - pole)), its limit along `inward` at the apex, and the gradient."""
    from_apex, from_pole = x - apex, x - pole
    is_apex = np.all(from_apex == 0, axis=1)
    seen = np.where(is_apex[:, None], inward, from_apex)
    cosine = np.sum(seen * from_pole, axis=1)
    sine = seen[:, 1] * from_pole[:, 0] - seen[:, 0] * from_pole[:, 1]
    return np.arctan2(sine, cosine), _argument_gradient(from_apex) - _argument_gradient(from_pole)
