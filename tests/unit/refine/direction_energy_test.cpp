#include "refine/direction_energy.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "refine/point_energy.hpp"

namespace quadrille::refine {
namespace {

constexpr double step = 1e-5;
const Vec2 a{0.8, 0.3}, target{1.1, -0.7};

TEST(DirectionEnergy, IsZeroAlongTheCrossWhateverTheLength) {
  for (const double turn : {0.0, 1.0, 2.0, 3.0})
    EXPECT_NEAR(DirectionEnergy(7 * unit(0.3 + turn * std::acos(0.0)), 2 * unit(4 * 0.3)).value, 0, 1e-14);
}

TEST(DirectionEnergy, DerivativesAreThoseOfDifferences) {
  const Eigen::Matrix2d bend = direction_bend(a, target);
  for (const int k : {0, 1}) {
    const Vec2 d = k == 0 ? Vec2{step, 0} : Vec2{0, step};
    const DirectionEnergy more(a + d, target), less(a - d, target);
    EXPECT_NEAR(k == 0 ? DirectionEnergy(a, target).by_a.x : DirectionEnergy(a, target).by_a.y,
                (more.value - less.value) / (2 * step), 1e-7);
    EXPECT_NEAR(bend(0, k), (more.by_a.x - less.by_a.x) / (2 * step), 1e-6);
    EXPECT_NEAR(bend(1, k), (more.by_a.y - less.by_a.y) / (2 * step), 1e-6);
  }
}

/// Along the cross all curvatures are positive.
TEST(DirectionEnergy, IsPartOfTheHessianAtAPoint) {
  const Vec2 x = unit(0.2), y = 1.1 * unit(0.2 + std::acos(0.0)), cross = 5 * unit(0.8);
  const auto gradient = [&](const Eigen::Vector4d& move) {
    const Vec2 p = x + Vec2{move[0], move[1]}, q = y + Vec2{move[2], move[3]};
    const PointEnergy of(p, q, 2);
    const Vec2 by_p = of.by_a + DirectionEnergy(p, cross).by_a, by_q = of.by_b + DirectionEnergy(q, cross).by_a;
    return Eigen::Vector4d(by_p.x, by_p.y, by_q.x, by_q.y);
  };
  Eigen::Matrix4d of_directions = Eigen::Matrix4d::Zero();
  of_directions.topLeftCorner<2, 2>() = direction_bend(x, cross);
  of_directions.bottomRightCorner<2, 2>() = direction_bend(y, cross);
  const Eigen::Matrix4d hessian = point_hessian(x, y, 2, of_directions);
  for (int k = 0; k < 4; ++k) {
    const Eigen::Vector4d d = step * Eigen::Vector4d::Unit(k);
    EXPECT_LT((hessian.col(k) - (gradient(d) - gradient(-d)) / (2 * step)).norm(), 1e-6);
  }
}

TEST(DirectionEnergy, TheRootOfItsCurvatureIsAcrossTheSide) {
  const Vec2 root = root_of_direction_bend(2 * unit(0.2), 5 * unit(0.8));
  EXPECT_NEAR(distance(root, std::sqrt(16 * 5) / 2 * unit(0.2 + std::acos(0.0))), 0, 1e-12);
}

}  // namespace
}  // namespace quadrille::refine
