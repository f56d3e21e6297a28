#include "stiffness/edge_rules.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "spectral/modified_basis.hpp"
#include "spectral/orthogonal_basis.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::stiffness {
namespace {

constexpr int extra_points = 6;  // on curved edges

EdgeRule make_edge_rule(int order, int num_points) {
  EdgeRule edge{spectral::gauss_legendre(num_points), Eigen::MatrixXd(num_points, 2 * order)};
  std::vector<double> values(order);
  for (int i = 0; i < num_points; ++i) {
    const double s = edge.rule.points[i];
    spectral::edge_mode_values(order, s, values.data());
    edge.modes(i, 0) = (1 - s) / 2;
    edge.modes(i, 1) = (1 + s) / 2;
    for (int d = 2; d <= order; ++d) {
      edge.modes(i, d) = values[d - 2];
      edge.modes(i, order + d - 1) = -std::sqrt((2 * d - 1) / 2.0) * spectral::jacobi(d - 1, 0, 0, s);
    }
  }
  return edge;
}

// The modes of maps of one order along the edges.
struct MapTable {
  Eigen::MatrixXd values, slopes;  ///< points of edges 0, 1, 2 x modes
};

MapTable make_map_table(int order, int map_order) {
  const std::vector<double>& points = edge_rule(order, true).rule.points;
  const int n = static_cast<int>(points.size()), num_modes = spectral::num_tri_modes(map_order);
  MapTable table{Eigen::MatrixXd(3 * n, num_modes), Eigen::MatrixXd(3 * n, num_modes)};
  Eigen::VectorXd f(num_modes), f1(num_modes), f2(num_modes);
  for (int edge = 0; edge < 3; ++edge) {
    const Vec2 along = (spectral::tri_edge_point(edge, 1) - spectral::tri_edge_point(edge, 0)) / 2;
    for (int i = 0; i < n; ++i) {
      const Vec2 xi = spectral::tri_edge_point(edge, (1 + points[i]) / 2);
      spectral::orthogonal_gradients(map_order, xi, f.data(), f1.data(), f2.data());
      table.values.row(edge * n + i) = f;
      table.slopes.row(edge * n + i) = along.x * f1 + along.y * f2;
    }
  }
  return table;
}

const MapTable& map_table(int order, int map_order) {
  static spectral::PerOrder<MapTable> tables([](int key) { return make_map_table(key / 100, key % 100); });
  return tables[100 * order + map_order];
}

using Vector = Eigen::Map<const Eigen::VectorXd>;
Vector as_vector(const std::vector<double>& values) { return {values.data(), std::ssize(values)}; }

}  // namespace

const EdgeRule& edge_rule(int order, bool is_curved) {
  static spectral::PerOrder<EdgeRule> straight([](int n) { return make_edge_rule(n, harmonic_degree(n)); });
  static spectral::PerOrder<EdgeRule> curved(
      [](int n) { return make_edge_rule(n, harmonic_degree(n) + extra_points); });
  return is_curved ? curved[order] : straight[order];
}

EdgePoints edge_points(const spectral::TriMap& map, const HarmonicFrame& frame, int order) {
  const spectral::Quadrature& rule = edge_rule(order, !map.is_affine()).rule;
  const Eigen::ArrayXd s = as_vector(rule.points), weights = as_vector(rule.weights);
  const Eigen::Index n = s.size();
  EdgePoints points{Eigen::ArrayXcd(3 * n), Eigen::ArrayXcd(3 * n)};
  if (map.is_affine()) {
    for (int edge = 0; edge < 3; ++edge) {
      const std::complex<double> begin = frame(map.position(spectral::tri_edge_point(edge, 0))),
                                 end = frame(map.position(spectral::tri_edge_point(edge, 1)));
      points.z.segment(edge * n, n) = (begin + end) / 2.0 + (end - begin) / 2.0 * s;
      points.dz.segment(edge * n, n) = (end - begin) / 2.0 * weights;
    }
    return points;
  }
  const MapTable& table = map_table(order, map.order());
  const Vector x = as_vector(map.coefs_x()), y = as_vector(map.coefs_y());
  points.z.real() = (table.values * x).array() - frame.centre.x;
  points.z.imag() = (table.values * y).array() - frame.centre.y;
  points.dz.real() = (table.slopes * x).array() * weights.replicate(3, 1);
  points.dz.imag() = (table.slopes * y).array() * weights.replicate(3, 1);
  points.z *= frame.scale;
  points.dz *= frame.scale;
  return points;
}

}  // namespace quadrille::stiffness
