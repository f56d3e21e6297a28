#include "galerkin/hole_winding.hpp"

#include <gtest/gtest.h>

namespace quadrille::galerkin {
namespace {

double norm2(const Eigen::MatrixXd& gram, const Eigen::VectorXd& x) { return x.dot(gram * x); }

TEST(NearestHoleWinding, OfOneHoleIsRounded) {
  const Eigen::MatrixXd gram = Eigen::MatrixXd::Constant(1, 1, 3.7);
  for (const auto& [target, expected] : {std::pair{0.2, 0}, {-1.4, -1}, {2.51, 3}, {-0.9, -1}})
    EXPECT_EQ(nearest_hole_winding(gram, Eigen::VectorXd::Constant(1, target)), std::vector<int>{expected});
}

TEST(NearestHoleWinding, TiesDoNotDependOnRoundingErrors) {
  const Eigen::MatrixXd gram = Eigen::MatrixXd::Identity(1, 1);
  for (const double noise : {-1e-9, 0.0, 1e-9})
    EXPECT_EQ(nearest_hole_winding(gram, Eigen::VectorXd::Constant(1, 1.5 + noise)), std::vector<int>{1});
}

TEST(NearestHoleWinding, IsBetterThanRoundingIfHolesAreCoupled) {
  Eigen::MatrixXd gram(2, 2);
  gram << 1, -0.95, -0.95, 1;
  const Eigen::Vector2d target(0.45, 0.55);
  const std::vector<int> winding = nearest_hole_winding(gram, target);
  const Eigen::Vector2d found(winding[0], winding[1]);
  double least = INFINITY;
  for (int a = -5; a <= 5; ++a) {
    for (int b = -5; b <= 5; ++b) least = std::min(least, norm2(gram, Eigen::Vector2d(a, b) - target));
  }
  EXPECT_NEAR(norm2(gram, found - target), least, 1e-14);
  EXPECT_GT(norm2(gram, Eigen::Vector2d(0, 1) - target), least + 0.1);  // plain rounding
}

}  // namespace
}  // namespace quadrille::galerkin
