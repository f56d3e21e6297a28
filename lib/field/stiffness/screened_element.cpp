#include "stiffness/screened_element.hpp"

#include "base/error.hpp"
#include "spectral/modified_basis.hpp"
#include "spectral/per_order.hpp"

namespace quadrille::stiffness {
namespace {

constexpr int points_beyond_order = 10;  ///< mu is no polynomial

struct ScreenedRule {
  explicit ScreenedRule(int order);
  std::vector<Vec2> points;  ///< of the reference triangle
  Eigen::VectorXd weights;
  Eigen::MatrixXd values;  ///< of the modes: points x modes
};

ScreenedRule::ScreenedRule(int order) {
  const spectral::FactoredModes modes = spectral::factored_modes(order, order + points_beyond_order);
  const auto n = static_cast<int>(modes.eta1.points.size());
  weights.resize(n * n);
  values.resize(n * n, modes.g.cols());
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const double t = (1 - modes.eta2.points[j]) / 2;
      points.push_back({(1 + modes.eta1.points[i]) * t - 1, modes.eta2.points[j]});
      weights[i + n * j] = modes.eta1.weights[i] * modes.eta2.weights[j] / 2;
    }
  for (int c = 0; c < modes.num_factors(); ++c)
    for (int m = modes.first[c]; m < modes.first[c + 1]; ++m)
      for (int j = 0; j < n; ++j) values.col(modes.position[m]).segment(n * j, n) = modes.g(j, m) * modes.f.col(c);
}

const ScreenedRule& rule_of(int order) { return spectral::table_per_order<ScreenedRule>(order); }

}  // namespace

std::vector<Vec2> rule_points(const spectral::TriMap& map, int order) {
  std::vector<Vec2> points;
  for (const Vec2 xi : rule_of(order).points) points.push_back(map.position(xi));
  return points;
}

ScreenedElement screened_element(const spectral::TriMap& map, int order, const Eigen::VectorXd& rate) {
  const ScreenedRule& rule = rule_of(order);
  ScreenedElement screened;
  screened.weights = rule.weights;
  for (Eigen::Index q = 0; q < rule.weights.size(); ++q) {
    Vec2 x;
    Mat2 j;
    map.evaluate(rule.points[q], x, j);
    screened.weights[q] *= det(j);
  }
  const Eigen::VectorXd scale = screened.weights.cwiseProduct(rate);
  const Eigen::MatrixXd matrix =
      stiffness_matrix(map, order) + rule.values.transpose() * (scale.asDiagonal() * rule.values);
  screened.element = condense(order, matrix);
  if (const int ni = spectral::num_interior_modes(order); ni > 0)
    screened.factors.compute(matrix.bottomRightCorner(ni, ni));
  return screened;
}

ElementLoad element_load(int order, const ScreenedElement& element, const Eigen::MatrixXd& values) {
  const Eigen::MatrixXd all = rule_of(order).values.transpose() * (element.weights.asDiagonal() * values);
  const int nb = spectral::num_boundary_modes(order), ni = spectral::num_interior_modes(order);
  ElementLoad load{all.topRows(nb), all.bottomRows(ni)};
  if (ni == 0) return load;
  load.boundary += element.element.interior->transpose() * load.interior;
  element.factors.solveInPlace(load.interior);
  return load;
}

Eigen::MatrixXd all_modes(const ScreenedElement& element, const ElementLoad& load, const Eigen::MatrixXd& boundary) {
  Eigen::MatrixXd modes(boundary.rows() + load.interior.rows(), boundary.cols());
  modes << boundary, *element.element.interior * boundary + load.interior;
  return modes;
}

Eigen::MatrixXd values_at_points(int order, const Eigen::MatrixXd& modes) { return rule_of(order).values * modes; }

}  // namespace quadrille::stiffness
