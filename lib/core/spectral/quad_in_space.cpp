#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "spectral/bernstein_tables.hpp"
#include "spectral/quad_map.hpp"
#include "spectral/quad_samples.hpp"

namespace quadrille::spectral {

namespace {

/// The derivatives along xi1 and xi2 at xi = 0.
std::array<Vec3, 2> central_derivatives(int order, const Vec3* nodes) {
  const Eigen::MatrixXd at = interpolation_matrix(gll_points(order), {0.0});
  const Eigen::MatrixXd slope = at * differentiation_matrix(gll_points(order));
  std::array<Vec3, 2> d{};
  for (int j = 0; j <= order; ++j)
    for (int i = 0; i <= order; ++i) {
      const Vec3 x = nodes[j * (order + 1) + i] - nodes[0];
      d[0] += slope(0, i) * at(0, j) * x;
      d[1] += at(0, i) * slope(0, j) * x;
    }
  return d;
}

/// The axes of the plane of projection; zero if the element has no normal at its centre.
std::array<Vec3, 2> projection_axes(int order, const Vec3* nodes) {
  const auto [a, b] = central_derivatives(order, nodes);
  const Vec3 n = cross(a, b);
  if (!(norm2(n) > 0)) return {};
  const Vec3 e1 = normalized(a);
  return {e1, cross(normalized(n), e1)};
}

}  // namespace

std::vector<Vec2> quad_projection(int order, const Vec3* nodes) {
  const auto [e1, e2] = projection_axes(order, nodes);
  std::vector<Vec2> projected;
  for (int k = 0; k < (order + 1) * (order + 1); ++k) {
    const Vec3 x = nodes[k] - nodes[0];
    projected.push_back({dot(x, e1), dot(x, e2)});
  }
  return projected;
}

// A projected node is off by a few units in the last place of the element's size. The polynomial through such
// differences is at most lebesgue^2 times as great (the constant of the Gauss-Lobatto-Legendre nodes is below 3 up to
// order 30), its derivatives N^2 times that (Markov). Axes that are not quite orthonormal only change n0.
double quad_normal_lower_bound(int order, const Vec3* nodes, int depth) {
  constexpr double lebesgue = 3, ulps = 8;
  const std::vector<Vec2> projected = quad_projection(order, nodes);
  double size = 0;
  for (const Vec2 x : projected) size = std::max(size, norm(x));
  const double growth = lebesgue * lebesgue * order * order;
  const double below = 2 * growth * growth * size * ulps * unit_roundoff * size;
  return quad_jacobian_lower_bound(order, projected.data(), depth) - below;
}

ScaledJacobianMinimum quad_scaled_jacobian_minimum(int order, const Vec3* nodes) {
  const int count = (order + 1) * (order + 1);
  const auto [e1, e2] = projection_axes(order, nodes);
  const Vec3 normal = cross(e1, e2);
  Vector x(count), y(count), z(count);
  for (int k = 0; k < count; ++k) {
    const Vec3 offset = nodes[k] - nodes[0];
    x[k] = offset.x, y[k] = offset.y, z[k] = offset.z;
  }
  const auto dx = sampled_derivatives(order, x), dy = sampled_derivatives(order, y), dz = sampled_derivatives(order, z);
  std::vector<double> values(dx[0].size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    const Vec3 a{dx[0][k], dy[0][k], dz[0][k]}, b{dx[1][k], dy[1][k], dz[1][k]}, n = cross(a, b);
    const double scale = std::sqrt(norm2(a) * norm2(b));
    values[k] = scale > 0 && dot(n, normal) > 0 ? norm(n) / scale : -1.0;
  }
  const auto [value, xi] = least_sample(values);
  return {value, xi};
}

}  // namespace quadrille::spectral
