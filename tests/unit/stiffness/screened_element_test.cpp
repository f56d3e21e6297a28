#include "stiffness/screened_element.hpp"

#include <gtest/gtest.h>

#include "spectral/modified_basis.hpp"

namespace quadrille::stiffness {
namespace {

const spectral::TriMap map({Vec2{0.2, 0.1}, Vec2{1.5, 0.4}, Vec2{0.4, 1.3}});
constexpr int order = 7;

double rate(Vec2 x) { return 2 + std::sin(3 * x.x - x.y); }

/// The values of a function at the points.
template <class Function>
Eigen::VectorXd at_points(const Function& f) {
  const std::vector<Vec2> points = rule_points(map, order);
  Eigen::VectorXd values(std::ssize(points));
  for (Eigen::Index q = 0; q < values.size(); ++q) values[q] = f(points[static_cast<std::size_t>(q)]);
  return values;
}

TEST(ScreenedElement, WithoutARateItIsThatOfLaplacesEquation) {
  const ScreenedElement element = screened_element(map, order, at_points([](Vec2) { return 0.0; }));
  const CondensedElement expected = condense(order, stiffness_matrix(map, order));
  EXPECT_LT((element.element.schur.dense() - expected.schur.dense()).norm(), 1e-12);
}

TEST(ScreenedElement, APolynomialIsTheSolutionOfItsEquation) {
  const auto p = [](Vec2 x) { return x.x * x.x * x.x * x.y * x.y - 2 * x.y * x.y * x.y * x.y; };
  const auto laplacian = [](Vec2 x) { return 6 * x.x * x.y * x.y + 2 * x.x * x.x * x.x - 24 * x.y * x.y; };
  const ScreenedElement element = screened_element(map, order, at_points(rate));
  const ElementLoad load =
      element_load(order, element, at_points([&](Vec2 x) { return rate(x) * p(x) - laplacian(x); }));
  const Eigen::MatrixXd modes_to_points = values_at_points(
      order, Eigen::MatrixXd::Identity(spectral::num_boundary_modes(order) + spectral::num_interior_modes(order),
                                       spectral::num_boundary_modes(order) + spectral::num_interior_modes(order)));
  const Eigen::VectorXd values = at_points(p), modes = modes_to_points.householderQr().solve(values);
  const Eigen::MatrixXd all = all_modes(element, load, modes.head(spectral::num_boundary_modes(order)));
  EXPECT_LT((all - modes).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_LT((values_at_points(order, all) - values).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(ScreenedElement, WeightsSumUpToTheArea) {
  const ScreenedElement element = screened_element(map, order, at_points(rate));
  EXPECT_NEAR(element.weights.sum(), cross({1.3, 0.3}, {0.2, 1.2}) / 2, 1e-14);
}

}  // namespace
}  // namespace quadrille::stiffness
