#pragma once
// Nodes on one line that leaves a wall: cut by its distance from the wall below, by its length above.

#include <functional>
#include <vector>

#include "refine/wall_line.hpp"

namespace quadrille {

/// A line across a block, for u in [0, 1].
using ColumnCurve = std::function<Vec2(double)>;

/// The heights of all nodes of layers with these upper ends: Gauss-Lobatto-Legendre points of each layer, without 0.
std::vector<double> node_heights(const std::vector<double>& layer_heights, int order);

/// The first u at which `curve`, which starts on the wall at `foot`, is at each of the rising heights, to round-off.
/// Shorter where the curve turns back or ends before.
std::vector<double> parameters_at_heights(const ColumnCurve& curve, const WallLine& wall, WallFoot foot,
                                          const std::vector<double>& heights);

/// The parameters in [low, high] between which the curve has the given shares of its length there; shares rise from 0
/// to 1. By 32 samples.
std::vector<double> parameters_at_shares(const ColumnCurve& curve, double low, double high,
                                         const std::vector<double>& shares);

/// Length of the curve between low and high by 32 samples.
double column_length(const ColumnCurve& curve, double low, double high);

}  // namespace quadrille
