#include "refine/point_energy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace quadrille::refine {
namespace {

constexpr double step = 1e-5;

TEST(PointEnergy, OfAUnitSquareIsOneAndTheWeight) {
  EXPECT_NEAR(PointEnergy({1, 0}, {0, 1}, 3).value, 1 + 3, 1e-15);
  // a^8 = 256 and b^8 = 1, det = 2, mu = 5/4.
  EXPECT_NEAR(PointEnergy({2, 0}, {0, 1}, 3).value, 257.0 / 2 * 2 + 3 * std::pow(1.25, 3), 1e-12);
}

TEST(PointEnergy, DoesNotDependOnTheFrame) {
  const Vec2 a{0.9, 0.2}, b{-0.3, 1.1};
  const auto turned = [](Vec2 x) { return x.x * unit(0.7) + x.y * left_of(unit(0.7)); };
  EXPECT_NEAR(PointEnergy(turned(a), turned(b), 2).value, PointEnergy(a, b, 2).value, 1e-13);
  EXPECT_NEAR(PointEnergy(b, -a, 2).value, PointEnergy(a, b, 2).value, 1e-13) << "the next side";
}

/// By the moves of a and b.
Eigen::Vector4d gradient(Vec2 a, Vec2 b, double weight) {
  const PointEnergy of(a, b, weight);
  return {of.by_a.x, of.by_a.y, of.by_b.x, of.by_b.y};
}

TEST(PointEnergy, DerivativesAreThoseOfDifferences) {
  const Vec2 a{0.9, 0.2}, b{-0.3, 1.1};
  for (int k = 0; k < 4; ++k) {
    const Eigen::Vector4d d = step * Eigen::Vector4d::Unit(k);
    const Vec2 da{d[0], d[1]}, db{d[2], d[3]};
    EXPECT_NEAR(gradient(a, b, 2)[k],
                (PointEnergy(a + da, b + db, 2).value - PointEnergy(a - da, b - db, 2).value) / (2 * step), 1e-6);
  }
}

TEST(PointHessian, IsTheSlopeOfTheGradientWhereThatIsPositive) {
  const Vec2 a{0.9, 0.2}, b{-0.3, 1.1};
  const Eigen::Matrix4d hessian = point_hessian(a, b, 2, Eigen::Matrix4d::Zero());
  for (int k = 0; k < 4; ++k) {
    const Eigen::Vector4d d = step * Eigen::Vector4d::Unit(k);
    const Vec2 da{d[0], d[1]}, db{d[2], d[3]};
    const Eigen::Vector4d slope = (gradient(a + da, b + db, 2) - gradient(a - da, b - db, 2)) / (2 * step);
    EXPECT_LT((hessian.col(k) - slope).norm(), 1e-5);
  }
}

/// Of other terms that bend downwards, curvatures count by their absolute values.
TEST(PointHessian, IsPositiveWhateverIsAdded) {
  const Vec2 a{0.9, 0.2}, b{-0.3, 1.1};
  const Eigen::Matrix4d plain = point_hessian(a, b, 2, Eigen::Matrix4d::Zero());
  const Eigen::Matrix4d lowered = point_hessian(a, b, 2, -1000 * Eigen::Matrix4d::Identity());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> was(plain), is(lowered);
  for (int k = 0; k < 4; ++k)
    EXPECT_NEAR(is.eigenvalues()[3 - k], 1000 - was.eigenvalues()[k], 1e-9) << "all lie between 0 and 1000";
  EXPECT_GT(is.eigenvalues()[0], 0);
}

/// At a square, where mu has no slope, the blocks are the second derivatives by one of a and b.
TEST(PointBends, AreWhatIsPositiveOfTheHessian) {
  const Vec2 a{1, 0}, b{0, 1};
  const auto [xx, xy, yy] = PointBends(a, b, 2).block(1, 0);
  EXPECT_GT(xx, 0);
  EXPECT_GT(xx * yy - xy * xy, 0);
  const auto [tt_xx, tt_xy, tt_yy] = PointBends(a, b, 2).block(0, 1);
  EXPECT_NEAR(xx, tt_yy, 1e-12) << "the square turned by 90 degrees";
  EXPECT_NEAR(yy, tt_xx, 1e-12);
  EXPECT_NEAR(xy, tt_xy, 1e-12);
}

/// Each point of n x n is seen once from each side; the side's own points come first.
TEST(SideFrame, PointsOfASideRunAroundTheElement) {
  constexpr int n = 4;
  for (int side = 0; side < 4; ++side) {
    const SideFrame at = side_frame(side, n);
    std::set<int> seen;
    for (int r = 0; r < n; ++r)
      for (int p = 0; p < n; ++p) seen.insert(at.point(p, r));
    EXPECT_EQ(seen.size(), 16u);
    EXPECT_EQ(*seen.begin(), 0);
    EXPECT_EQ(*seen.rbegin(), 15);
    EXPECT_EQ(at.point(n - 1, 0), side_frame((side + 1) % 4, n).point(0, 0)) << "where the next side begins";
    int visited = -1;
    with_side(side, [&](auto known) { visited = known; });
    EXPECT_EQ(visited, side);
  }
}

TEST(CornerSlopes, ReproduceLinearFunctions) {
  const std::array<Vec2, 4> corner{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  for (const Vec2 x : {Vec2{0, 0}, Vec2{0.3, 0.8}}) {
    const std::array<Vec2, 4> slopes = corner_slopes(x.x, x.y);
    Vec2 sum, of_s, of_t;
    for (int k = 0; k < 4; ++k) sum += slopes[k], of_s += corner[k].x * slopes[k], of_t += corner[k].y * slopes[k];
    EXPECT_LT(norm(sum), 1e-15);
    EXPECT_LT(distance(of_s, {1, 0}), 1e-15);
    EXPECT_LT(distance(of_t, {0, 1}), 1e-15);
  }
}

}  // namespace
}  // namespace quadrille::refine
