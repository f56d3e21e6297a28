#pragma once
// The shape of a block, taken as ONE quad of order 8: the one place where it is judged.
//
// The quad interpolates the block's exact map (mesh/transfinite.hpp) in the Gauss-Lobatto-Legendre points.

#include "base/vec2.hpp"
#include "mesh/transfinite.hpp"

namespace quadrille::mesh {

/// Blocks are judged as quads of this order (TransfiniteMap::sampled).
constexpr int block_order = 8;

struct BlockShape {
  double jacobian_bound = 0;   ///< least Bernstein bound of det J, length^2 (spectral/quad_map.hpp)
  double scaled_jacobian = 0;  ///< least sampled one, -1 where det J <= 0
  Vec2 scaled_jacobian_place;  ///< where, relative to the face's origin

  /// All Jacobians are proved positive.
  bool is_valid() const { return scaled_jacobian > 0 && jacobian_bound > 0; }
};

BlockShape block_shape(const TransfiniteMap& map);

}  // namespace quadrille::mesh
