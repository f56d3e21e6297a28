"""The chart of a curved face: triangles in the plane in which it is meshed, and on the surface (formats/chart.md)."""
import numpy as np

from .face import Face
from .stage_result import StageResult


class Chart(StageResult):
    """A curved face in its chart.

    `face`: Face, in the plane of the chart; `order`; of the K = (P + 1)(P + 2)/2 nodes of each of m triangles: `nodes`
    [m, K, 2] in the chart, `space_nodes` [m, K, 3] in the coordinates of the CAD file, `uv` [m, K, 2], `log_scale`
    [m, K]: the logarithm of a length in space over one in the chart; `closedness`: error of angles in radians.
    """

    def __init__(self, content):
        self.face = Face(content["face"])
        chart = content["face"]["chart"]
        self.order = int(chart["order"])
        per_elem = (self.order + 1) * (self.order + 2) // 2
        self.nodes = np.asarray(chart["nodes"], float).reshape(-1, per_elem, 2) + self.face.origin
        self.space_nodes = np.asarray(chart["space_nodes"], float).reshape(-1, per_elem, 3)
        self.uv = np.asarray(chart["uv"], float).reshape(-1, per_elem, 2)
        self.log_scale = np.asarray(chart["log_scale"], float).reshape(-1, per_elem)
        self.closedness = float(chart["closedness"])

    def summary(self):
        return f"{self.num_elements} triangles of order {self.order}"

    @property
    def num_elements(self):
        return len(self.nodes)
