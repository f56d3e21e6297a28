#include "mesh/transfinite.hpp"

#include <vector>

#include "spectral/quad_map.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::mesh {

Vec2 blend_sides(const std::array<Vec2, 4>& on_sides, const std::array<Vec2, 4>& corners, double s, double t) {
  if (t == 0) return on_sides[0];
  if (s == 1) return on_sides[1];
  if (t == 1) return on_sides[2];
  if (s == 0) return on_sides[3];
  const Vec2 bilinear = (1 - t) * ((1 - s) * corners[0] + s * corners[1]) + t * ((1 - s) * corners[3] + s * corners[2]);
  const Vec2 ruled_t = (1 - t) * on_sides[0] + t * on_sides[2];
  const Vec2 ruled_s = (1 - s) * on_sides[3] + s * on_sides[1];
  return ruled_t + ruled_s - bilinear;
}

Vec2 crossing_parameters(double f0, double f1, double f2, double f3) {
  const double ds = f2 - f0, dt = f1 - f3;
  const double s = (f0 + f3 * ds) / (1 - ds * dt);
  return {s, f3 + s * dt};
}

TransfiniteMap::TransfiniteMap(const std::array<const curve::Chain*, 4>& sides, const std::array<bool, 4>& backwards)
    : sides_(sides), backwards_(backwards) {
  for (int k = 0; k < 4; ++k) corners_[k] = side(k, 0);
}

Vec2 TransfiniteMap::side(int k, double fraction) const {
  return sides_[k]->position(backwards_[k] ? 1 - fraction : fraction);
}

Vec2 TransfiniteMap::position(double s, double t) const {
  if (t == 0) return side(0, s);
  if (s == 1) return side(1, t);
  if (t == 1) return side(2, 1 - s);
  if (s == 0) return side(3, 1 - t);
  return blend_sides({side(0, s), side(1, t), side(2, 1 - s), side(3, 1 - t)}, corners_, s, t);
}

std::vector<Vec2> TransfiniteMap::sampled(int order) const {
  std::vector<double> fractions;
  for (const double xi : spectral::gll_points(order)) fractions.push_back((1 + xi) / 2);
  std::array<std::vector<Vec2>, 4> on_sides;  // once per side, not per node
  for (int k = 0; k < 4; ++k)
    for (const double f : fractions) on_sides[k].push_back(side(k, k < 2 ? f : 1 - f));
  std::vector<Vec2> nodes;
  for (int j = 0; j <= order; ++j)
    for (int i = 0; i <= order; ++i)
      nodes.push_back(blend_sides({on_sides[0][i], on_sides[1][j], on_sides[2][i], on_sides[3][j]}, corners_,
                                  fractions[i], fractions[j]));
  return nodes;
}

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
