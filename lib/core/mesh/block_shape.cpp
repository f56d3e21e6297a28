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

double scaled_jacobian(const std::vector<Vec2>& nodes) {
  return spectral::quad_scaled_jacobian(block_order, nodes.data());
}

bool is_valid_block(const std::vector<Vec2>& nodes) {
  return scaled_jacobian(nodes) > 0 && spectral::quad_jacobian_lower_bound(block_order, nodes.data()) > 0;
}

}  // namespace quadrille::mesh
