#pragma once
// Wall-normal lines: lines of mesh nodes that start at a wall, and the parameters at which they reach given heights.

#include <functional>
#include <vector>

#include "layers/wall_line.hpp"

namespace quadrille::layers {

/// A line across a block, for u in [0, 1].
using NormalLine = std::function<Vec2(double)>;

/// The heights of all nodes of layers with these upper ends: Gauss-Lobatto-Legendre points of each layer, without 0.
std::vector<double> node_heights(const std::vector<double>& layer_heights, int order);

/// The height of the end of the line, which starts on the wall at `foot`.
double height_of_end(const NormalLine& line, const WallLine& wall, WallPoint foot);

/// The first u at which the line, which starts on the wall at `foot`, is at each of the rising heights, to 1e-11 of the
/// height. Fewer parameters if the line turns back to the wall, or ends, before the last one.
std::vector<double> parameters_at_heights(const NormalLine& line, const WallLine& wall, WallPoint foot,
                                          const std::vector<double>& heights);

}  // namespace quadrille::layers
