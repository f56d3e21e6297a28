#pragma once
// The shape of a block as ONE quad of order 8: the only measure of block quality.
//
// The quad interpolates the block's exact map (mesh/transfinite.hpp) at the Gauss-Lobatto-Legendre points.

#include <vector>

#include "base/vec2.hpp"
#include "mesh/transfinite.hpp"

namespace quadrille::mesh {

/// Blocks are measured as quads of this order (TransfiniteMap::sampled).
constexpr int block_order = 8;

struct BlockShape {
  double jacobian_bound = 0;      ///< least Bernstein bound of det J, length^2 (spectral/quad_map.hpp)
  double scaled_jacobian = 0;     ///< least sampled value, -1 where det J <= 0
  Vec2 scaled_jacobian_position;  ///< position of that sample, relative to face.origin

  /// Whether det J is proved positive over the whole block.
  bool is_valid() const { return scaled_jacobian > 0 && jacobian_bound > 0; }
};

BlockShape block_shape(const TransfiniteMap& map);

/// BlockShape::scaled_jacobian of a block sampled at block_order (TransfiniteMap::sampled).
double scaled_jacobian(const std::vector<Vec2>& nodes);
/// BlockShape::is_valid of it; takes longer.
bool is_valid_block(const std::vector<Vec2>& nodes);

}  // namespace quadrille::mesh
