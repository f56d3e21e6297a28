#pragma once
// Where a line that leaves a wall is at given distances from it.

#include <functional>
#include <vector>

#include "layers/wall_line.hpp"

namespace quadrille::layers {

/// A line across a block, for u in [0, 1].
using ColumnCurve = std::function<Vec2(double)>;

/// The heights of all nodes of layers with these upper ends: Gauss-Lobatto-Legendre points of each layer, without 0.
std::vector<double> node_heights(const std::vector<double>& layer_heights, int order);

/// The first u at which `curve`, which starts on the wall at `foot`, is at each of the rising heights, to round-off.
/// Shorter where the curve turns back or ends before.
std::vector<double> parameters_at_heights(const ColumnCurve& curve, const WallLine& wall, WallFoot foot,
                                          const std::vector<double>& heights);

}  // namespace quadrille::layers
