"""The mesh of curved quads (formats/quad-mesh.md)."""
import numpy as np

from . import reference
from .face import Face
from .stage_result import Mesh

MEASURES = ("jacobian_bound", "scaled_jacobian", "edge_ratio", "area_jump", "node_distance")


class QuadMesh(Mesh):
    """Curved quads of one order.

    `face`: Face; `order`; `nodes` [n, 2]; `elem_nodes` [m, (N + 1)^2]: nodes of each element, xi1 fastest, at the
    Gauss-Lobatto-Legendre points; `elem_block` [m]; `block_names`; `boundary_edges`: a dict of arrays `elem`, `side`,
    `curve`; `interface_edges`: the same of edges on interfaces, once for each side; `elem_region` [m]: the region of
    each element in `face`; `elem_jacobian_bound`, `elem_scaled_jacobian`, `elem_edge_ratio`, `elem_area_jump`, `elem_node_distance`
    [m], None where the file has none; `is_valid`: every element is proved valid. Of a curved face `nodes` are in its
    chart and `space_nodes` [n, 3] in the coordinates of the CAD file; of a planar face `space_nodes` is None.
    """

    def __init__(self, content):
        self.face = Face(content["face"])
        self.order = int(content["order"])
        self.nodes = np.asarray(content["nodes"], float) + self.face.origin
        self.space_nodes = np.asarray(content["space_nodes"], float) if "space_nodes" in content else None
        self.elem_nodes = np.asarray(content["elem_nodes"]).reshape(-1, (self.order + 1) ** 2)
        self.elem_block = np.asarray(content["elem_block"])
        self.block_names = list(content["block_names"])
        keys = ("elem", "side", "curve")
        self.boundary_edges = {key: np.asarray(content["boundary_edges"][key]) for key in keys}
        interfaces = content.get("interface_edges", {})
        self.interface_edges = {key: np.asarray(interfaces.get(key, []), int) for key in keys}
        regions = np.asarray(content.get("block_region", [0] * len(self.block_names)), int)
        self.elem_region = regions[self.elem_block]
        self.is_valid = bool(content.get("is_valid", 1))
        self.num_irregular = int(content["num_irregular"])
        for measure in MEASURES:
            setattr(self, "elem_" + measure, content.get("elem_" + measure))

    def summary(self):
        parts = [f"{len(self.block_names)} blocks", f"{self.num_irregular} irregular nodes", f"{self.num_elements} quads"]
        if self.elem_scaled_jacobian is not None:
            parts.append(f"worst scaled Jacobian {np.min(self.elem_scaled_jacobian):.2g}")
        if self.elem_edge_ratio is not None:
            parts.append(f"greatest edge ratio {round(float(np.max(self.elem_edge_ratio)), 1):g}")
        return ", ".join(parts)

    @property
    def num_elements(self):
        return len(self.elem_nodes)

    @property
    def elem_names(self):
        """The name of the block of each element."""
        return [self.block_names[b] for b in self.elem_block]

    @property
    def boundary_names(self):
        """The name of the CAD curve of each boundary edge."""
        return [self.face.curve_names[c] for c in self.boundary_edges["curve"]]

    @property
    def corners(self):
        """Nodes at the four corners of each element [m, 4], counter-clockwise."""
        n = self.order
        return self.elem_nodes[:, [0, n, (n + 1) ** 2 - 1, n * (n + 1)]]

    def side_nodes(self, k):
        """Nodes along side k of each element [m, N + 1], from corner k to corner k + 1."""
        grid = self.elem_nodes.reshape(-1, self.order + 1, self.order + 1)
        return (grid[:, 0], grid[:, :, -1], grid[:, -1, ::-1], grid[:, ::-1, 0])[k]

    def map(self, elem, xi):
        """Positions [n, 2] and derivatives [n, 2, 2] (row: x or y) of the maps of elements [n] at xi [n, 2]."""
        elem, xi = np.atleast_1d(elem), np.asarray(xi, float).reshape(-1, 2)
        gll = reference.gll_points(self.order)
        (f, df), (g, dg) = reference.lagrange(gll, xi[:, 0]), reference.lagrange(gll, xi[:, 1])
        nodes = self.nodes[self.elem_nodes[elem]].reshape(len(elem), self.order + 1, self.order + 1, 2)
        parts = [np.einsum("njik,nj,ni->nk", nodes, b, a) for a, b in ((f, g), (df, g), (f, dg))]
        return parts[0], np.stack(parts[1:], axis=-1)

    def measure_scaled_jacobian(self, points=None):
        """The least scaled Jacobian of each element [m], on points x points points (default: 2 N + 3)."""
        return scaled_jacobian(self.nodes[self.elem_nodes], points)


def scaled_jacobian(quads, points=None):
    """The least det J / (|x_xi1| |x_xi2|) of quads given by nodes [m, (N + 1)^2, 2], on equally spaced points of each
    side (default: 2 N + 3), ends included; -1 where det J is not positive."""
    order = int(round(quads.shape[1] ** 0.5)) - 1
    value, slope = reference.lagrange(reference.gll_points(order), np.linspace(-1, 1, points or 2 * order + 3))
    grid = quads.reshape(-1, order + 1, order + 1, 2)
    d1 = np.einsum("mjik,bj,ai->mbak", grid, value, slope, optimize=True)
    d2 = np.einsum("mjik,bj,ai->mbak", grid, slope, value, optimize=True)
    det = d1[..., 0] * d2[..., 1] - d1[..., 1] * d2[..., 0]
    scaled = det / (np.linalg.norm(d1, axis=-1) * np.linalg.norm(d2, axis=-1))
    return np.where(det > 0, scaled, -1).reshape(len(grid), -1).min(axis=1)
