"""Four-sided blocks and their maps (formats/block-layout.md)."""
import numpy as np

from . import reference
from .graph import ArcGraph
from .quads import scaled_jacobian
from .stage_result import Exportable


class Block:
    """A block: `number`, `name`, `nodes` (four numbers, counter-clockwise), `sides` (four pairs of an Arc and True if it
    is followed forwards; side k runs from node k to node k + 1), `chords` (of sides 0 and 2, of sides 1 and 3),
    `jacobian_bound`, `scaled_jacobian`, `boundary_distance` (of the block as one quad of order 8, as in the file; None
    where it has none)."""

    def __init__(self, number, name, nodes, sides, chords):
        self.number, self.name, self.nodes, self.sides, self.chords = number, name, nodes, sides, chords
        self.jacobian_bound = self.scaled_jacobian = self.boundary_distance = None

    @property
    def boundary_names(self):
        """For each side the names of the CAD curves that it follows; empty for an inner side."""
        return [arc.names for arc, _ in self.sides]

    @property
    def side_lengths(self):
        """Arc lengths of the four sides."""
        return np.array([arc.arc_length for arc, _ in self.sides])

    def side_points(self, k, fraction):
        """Points [n, 2] of side k at fractions [n] of its length from node k."""
        arc, forwards = self.sides[k]
        fraction = np.atleast_1d(np.asarray(fraction, float))
        return arc.at(fraction if forwards else 1 - fraction)

    def map(self, xi):
        """Points [n, 2] of the block at xi [n, 2] in [-1, 1]^2: the bilinearly blended transfinite interpolation of the
        sides, each by arc length. Node 0 is at (-1, -1), node 1 at (1, -1)."""
        s, t = (np.asarray(xi, float).reshape(-1, 2).T + 1) / 2
        bottom, right = self.side_points(0, s), self.side_points(1, t)
        top, left = self.side_points(2, 1 - s), self.side_points(3, 1 - t)
        a, b, c, d = (self.side_points(k, [0.0])[0] for k in range(4))
        s, t = s[:, None], t[:, None]
        corners = (1 - s) * (1 - t) * a + s * (1 - t) * b + s * t * c + (1 - s) * t * d
        return (1 - t) * bottom + t * top + (1 - s) * left + s * right - corners

    def quad_nodes(self, order=8):
        """The block as one quad: its map at the Gauss-Lobatto-Legendre points [(N + 1)^2, 2], xi1 fastest."""
        y, x = np.meshgrid(*[reference.gll_points(order)] * 2, indexing="ij")
        return self.map(np.column_stack([x.ravel(), y.ravel()]))

    def measure(self, order=8, points=19):
        """The least scaled Jacobian of that quad on points x points points; -1 where it folds."""
        return float(scaled_jacobian(self.quad_nodes(order)[None], points)[0])


class BlockLayout(ArcGraph, Exportable):
    """Also `blocks`: Block; `arc_chord`: the chord of each arc (arcs of one chord are divided alike); `block_region`: the
    region of each block in `face`.
    """

    def __init__(self, content):
        super().__init__(content)
        self.arc_chord = np.asarray(content["arc_chord"])
        nodes, half_edges = np.asarray(content["block2nodes"]), np.asarray(content["block2arcs"])
        self.blocks = []
        for i, name in enumerate(content["block_names"]):
            sides = [(self.arcs[h if h >= 0 else -1 - h], bool(h >= 0)) for h in half_edges[i]]
            chords = tuple(int(self.arc_chord[arc.number]) for arc, _ in sides[:2])
            self.blocks.append(Block(i, name, tuple(int(n) for n in nodes[i]), sides, chords))
        self.block_region = np.asarray(content.get("block_region", [0] * len(self.blocks)), int)
        for member in ("jacobian_bound", "scaled_jacobian", "boundary_distance"):
            values = content.get("block_" + member, [])
            for block, value in zip(self.blocks, values):
                setattr(block, member, float(value))

    def summary(self):
        return f"{len(self.blocks)} blocks"

    def neighbour(self, block, k):
        """The block beyond side k of a block and the number of its side there, or None at the boundary."""
        arc = block.sides[k][0]
        for other in self.blocks:
            for j, (side, _) in enumerate(other.sides):
                if side is arc and (other, j) != (block, k):
                    return other, j
        return None
