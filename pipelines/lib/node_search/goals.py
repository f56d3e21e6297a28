"""What makes one layout better than another: the goal of the search, of the user's choice (quadplace --goal)."""
import math
from dataclasses import dataclass
from typing import Callable

LEAST_GAIN = 1e-4  # a smaller one, of the scaled Jacobian or relative, does not justify a field of its own
KEPT_SHAPE = 0.5  # goals other than the shape keep this part of the least scaled Jacobian at the start


def upper_bound(nodes):
    """Of the least scaled Jacobian for any positions: of V angles at a point one is at most the V-th part of all."""
    angles = [360 / point["valence"] for point in nodes["critical_points"] if point["valence"]]
    angles += [180 / point["valence"] for point in nodes.get("boundary_nodes", [])]
    angles += [corner["angle_degrees"] / corner["valence"] for corner in nodes["corners"] if corner["valence"]]
    return min((math.sin(math.radians(angle)) for angle in angles), default=1.0)


@dataclass(frozen=True)
class Goal:
    """`figure`: of a layout, what `text` names. `gains`: whether a layout is better than the best so far."""

    text: str
    verb: str  # what a better layout does to the figure
    figure: Callable
    gains: Callable
    is_reached: Callable  # whether no positions can be better than those of a layout

    def is_better(self, layout, best, start):
        """Never invalid, and never of much worse shape than the start, whatever the goal is."""
        return layout.quality > 0 and layout.quality >= KEPT_SHAPE * start.quality and self.gains(layout, best)


def has_better_shape(layout, best):
    return layout.quality >= best.quality + LEAST_GAIN


def has_fewer_blocks(layout, best):
    return layout.num_blocks < best.num_blocks or (layout.num_blocks == best.num_blocks and has_better_shape(layout, best))


GOALS = {
    "scaled-jacobian": Goal("least scaled Jacobian of the blocks", "raised", lambda layout: layout.quality, has_better_shape,
                            lambda layout: layout.quality >= upper_bound(layout.nodes) - LEAST_GAIN),
    "edge-ratio": Goal("greatest ratio of the sides of a block", "lowered", lambda layout: layout.edge_ratio,
                       lambda layout, best: layout.edge_ratio <= best.edge_ratio * (1 - LEAST_GAIN),
                       lambda layout: layout.edge_ratio <= 1 + LEAST_GAIN),
    "blocks": Goal("number of blocks", "lowered", lambda layout: layout.num_blocks, has_fewer_blocks,
                   lambda layout: layout.num_blocks == 1),
    "alignment": Goal("angle between crosses and directions, degrees", "lowered", lambda layout: layout.misalignment,
                      lambda layout, best: layout.misalignment < best.misalignment * (1 - LEAST_GAIN),
                      lambda layout: layout.misalignment <= LEAST_GAIN),
}
