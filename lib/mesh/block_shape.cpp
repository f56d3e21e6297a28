#include "mesh/block_shape.hpp"

#include <vector>

#include "spectral/quad_map.hpp"

namespace quadrille::mesh {

BlockShape block_shape(const TransfiniteMap& map) {
  const std::vector<Vec2> nodes = map.sampled(block_order);
  const spectral::ScaledJacobianMinimum scaled = spectral::quad_scaled_jacobian_minimum(block_order, nodes.data());
  return {spectral::quad_jacobian_lower_bound(block_order, nodes.data()), scaled.value,
          spectral::quad_position(block_order, nodes.data(), scaled.xi)};
}

}  // namespace quadrille::mesh
