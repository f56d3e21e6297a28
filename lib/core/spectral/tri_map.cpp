#include "spectral/tri_map.hpp"

#include <array>
#include <cmath>

#include "spectral/lagrange.hpp"
#include "spectral/orthogonal_basis.hpp"
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

// Values at tri_nodes(order) -> coefficients in the orthogonal basis.
const Eigen::MatrixXd& nodal_to_orthogonal(int order) {
  static PerOrder<Eigen::MatrixXd> tables([](int n) {
    const Eigen::MatrixXd vandermonde = orthogonal_vandermonde(n, tri_nodes(n));
    return Eigen::MatrixXd(vandermonde.partialPivLu().inverse());
  });
  return tables[order];
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

TriMap::TriMap(const std::array<Vec2, 3>& vertices) { set_affine(vertices.data()); }

TriMap::TriMap(int order, const Vec2* nodes) : order_(order) {
  if (order == 1) {
    set_affine(nodes);
    return;
  }
  const Eigen::MatrixXd& to_modes = nodal_to_orthogonal(order);
  const int n = num_tri_modes(order);
  // Offsets from a vertex are small, so no digits are lost in a tiny element far from the origin.
  Eigen::MatrixX2d offsets(n, 2);
  for (int i = 0; i < n; ++i) offsets.row(i) << nodes[i].x - nodes[0].x, nodes[i].y - nodes[0].y;
  const Eigen::MatrixX2d coefs = to_modes * offsets;
  coefs_x_.assign(coefs.col(0).begin(), coefs.col(0).end());
  coefs_y_.assign(coefs.col(1).begin(), coefs.col(1).end());
  const double constant = std::sqrt(2.0);  // the function 1 is this multiple of mode 0, whose value is 1 / sqrt(2)
  coefs_x_[0] += constant * nodes[0].x;
  coefs_y_[0] += constant * nodes[0].y;
}

void TriMap::set_affine(const Vec2* vertices) {
  const Vec2 a = vertices[0], b = vertices[1], c = vertices[2];
  centre_ = (b + c) / 2;
  jacobian_ = {(b.x - a.x) / 2, (c.x - a.x) / 2, (b.y - a.y) / 2, (c.y - a.y) / 2};
  // Modes 1 and 2 are (3 xi2 + 1) / 2 and sqrt(3) (xi1 + (1 + xi2) / 2); xi = (-1/3, -1/3) is the centroid.
  const double root2 = std::sqrt(2.0), root3 = std::sqrt(3.0);
  const Vec2 centroid = (a + b + c) / 3, across = (b - a) / 2, up = ((c - a) - (b - a) / 2) / 2;
  coefs_x_ = {root2 * centroid.x, 2 * up.x / 3, across.x / root3};
  coefs_y_ = {root2 * centroid.y, 2 * up.y / 3, across.y / root3};
}

Vec2 TriMap::position(Vec2 xi) const {
  if (is_affine()) return centre_ + jacobian_ * xi;
  return orthogonal_sum(order_, coefs_x_.data(), coefs_y_.data(), xi);
}

void TriMap::evaluate(Vec2 xi, Vec2& x, Mat2& dx_dxi) const {
  if (is_affine()) {
    x = centre_ + jacobian_ * xi;
    dx_dxi = jacobian_;
    return;
  }
  x = orthogonal_sum(order_, coefs_x_.data(), coefs_y_.data(), xi, dx_dxi);
}

bool TriMap::invert(Vec2 x, Vec2& xi) const {
  if (is_affine()) {
    xi = inverse(jacobian_) * (x - centre_);
    return true;
  }
  // Round-off in a tiny element far from the origin may prevent steps from reaching the strict limit: then they end
  // where they no longer become shorter.
  constexpr double converged = 1e-14, near = 1e-9;
  double last = HUGE_VAL;
  for (int iteration = 0; iteration < 40; ++iteration) {
    Vec2 here;
    Mat2 jacobian;
    evaluate(xi, here, jacobian);
    if (!(std::abs(det(jacobian)) > 0)) return false;
    Vec2 step = inverse(jacobian) * (x - here);
    const double length = norm(step);
    if (!std::isfinite(length)) return false;
    if (length > 0.5) step = step * (0.5 / length);
    xi = xi + step;
    if (norm2(xi) > 25) return false;
    if (length < converged || (length < near && length > last / 2)) return true;
    last = length;
  }
  return last < near;
}

Vec2 tri_edge_point(int edge, double s) {
  if (edge == 0) return {2 * s - 1, -1};
  if (edge == 1) return {1 - 2 * s, 2 * s - 1};
  return {-1, 1 - 2 * s};
}

}  // namespace quadrille::spectral
