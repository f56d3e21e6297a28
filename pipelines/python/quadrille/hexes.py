"""The mesh of curved hexahedra (formats/hex-mesh.md)."""
import numpy as np

from .stage_file import records
from .stage_result import Mesh


class HexMesh(Mesh):
    """Curved hexahedra of one order.

    `order`; `num_quads`: elements of a layer; `nodes` [n, 3] in the coordinates of the CAD model; `elem_nodes`
    [m, (N + 1)^3]: nodes of each element, xi1 fastest and xi3 slowest, at the Gauss-Lobatto-Legendre points;
    `region_names`; `elem_region` [m]; `face_groups`: a list of dicts with `name`, arrays `elems` and `faces`,
    `is_interface`, `periodic_with` (-1: none) and `motion` [3, 4], rows of matrix and shift; `elem_jacobian_bound`,
    `elem_scaled_jacobian` [m]; `is_valid`: every element is proved valid.
    """

    def __init__(self, content):
        self.order, self.num_quads = int(content["order"]), int(content["num_quads"])
        self.length_unit, self.diameter = content["length_unit"], float(content["diameter"])
        self.nodes = np.asarray(content["nodes"], float)
        self.elem_nodes = np.asarray(content["elem_nodes"]).reshape(-1, (self.order + 1) ** 3)
        self.region_names = list(content["region_names"])
        of_layer = np.asarray(content["block_region"], int)[np.asarray(content["quad_block"], int)]
        self.elem_region = np.tile(of_layer, self.num_layers)
        self.face_groups = [{**group, "is_interface": bool(group["is_interface"]),
                             "motion": np.asarray(group["motion"], float).reshape(3, 4)}
                            for group in records(content["face_groups"])]
        self.elem_jacobian_bound = np.asarray(content["elem_jacobian_bound"], float)
        self.elem_scaled_jacobian = np.asarray(content["elem_scaled_jacobian"], float)
        self.is_valid = bool(content["is_valid"])

    def summary(self):
        return (f"{self.num_elements} hexahedra of order {self.order} in {self.num_layers} layers, "
                f"worst scaled Jacobian {np.min(self.elem_scaled_jacobian):.2g}")

    @property
    def num_elements(self):
        return len(self.elem_nodes)

    @property
    def num_layers(self):
        return len(self.elem_nodes) // self.num_quads
