#include "spectral/tri_nodes.hpp"

#include <array>
#include <cmath>

#include "spectral/lagrange.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::spectral {

namespace {

// Warburton's blending parameter with the least Lebesgue constant, by order; 5/3 beyond the list.
double best_blend(int order) {
  constexpr std::array<double, 16> best{0,      0,      0,      1.4152, 0.1001, 0.2751, 0.9800, 1.0999,
                                        1.2832, 1.3648, 1.4773, 1.4959, 1.5743, 1.5770, 1.6223, 1.6258};
  return order < static_cast<int>(best.size()) ? best[order] : 5.0 / 3.0;
}

// The displacement of a point at r of an equispaced edge to a Gauss-Lobatto point, divided by 1 - r^2.
double warp(int order, double r) {
  std::vector<double> equispaced(order + 1);
  for (int i = 0; i <= order; ++i) equispaced[i] = -1 + 2.0 * i / order;
  const std::vector<double>& gll = gll_points(order);
  const Eigen::MatrixXd row = interpolation_matrix(equispaced, {r});
  double shift = 0;
  for (int i = 0; i <= order; ++i) shift += row(0, i) * (gll[i] - equispaced[i]);
  return shift / (1 - r * r);
}

// The interior node with equispaced barycentric coordinates l, moved along the direction of each edge.
Vec2 warped(int order, const std::array<double, 3>& l) {
  std::array<double, 3> b = l;
  const double blend = best_blend(order);
  for (int k = 0; k < 3; ++k) {
    // The edge from vertex a to vertex c, opposite vertex k.
    const int a = (k + 1) % 3, c = (k + 2) % 3;
    const double away = blend * l[k];
    const double shift = 4 * l[a] * l[c] * warp(order, l[c] - l[a]) * (1 + away * away) / 2;
    b[c] += shift;
    b[a] -= shift;
  }
  return {b[1] - b[0] - b[2], b[2] - b[0] - b[1]};
}

std::vector<Vec2> make_nodes(int order) {
  const std::array<Vec2, 3> vertices{Vec2{-1, -1}, Vec2{1, -1}, Vec2{-1, 1}};
  std::vector<Vec2> nodes(vertices.begin(), vertices.end());
  const std::vector<double>& gll = gll_points(order);
  for (int edge = 0; edge < 3; ++edge) {
    const Vec2 a = vertices[edge], b = vertices[(edge + 1) % 3];
    for (int j = 1; j < order; ++j) nodes.push_back(a * ((1 - gll[j]) / 2) + b * ((1 + gll[j]) / 2));
  }
  for (int k = 1; k < order; ++k) {
    for (int j = 1; j < order - k; ++j) {
      const double n = order;
      nodes.push_back(warped(order, {(order - j - k) / n, j / n, k / n}));
    }
  }
  return nodes;
}

}  // namespace

const std::vector<Vec2>& tri_nodes(int order) {
  static PerOrder<std::vector<Vec2>> tables(make_nodes);
  return tables[order];
}

int tri_edge_node(int order, int edge, int j) {
  if (j == 0) return edge;
  if (j == order) return (edge + 1) % 3;
  return 3 + edge * (order - 1) + j - 1;
}

}  // namespace quadrille::spectral
