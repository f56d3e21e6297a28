#include "refine/skew_energy.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quadrille::refine {
namespace {

double energy(const Eigen::Vector4d& x, double weight) {
  PointEnergy sum({x[0], x[1]}, {x[2], x[3]}, 0);
  const double size = sum.value;
  add_skewness({x[0], x[1]}, {x[2], x[3]}, weight, sum);
  return sum.value - size;
}

Eigen::Vector4d gradient(const Eigen::Vector4d& x, double weight) {
  const PointEnergy size({x[0], x[1]}, {x[2], x[3]}, 0);
  PointEnergy sum = size;
  add_skewness({x[0], x[1]}, {x[2], x[3]}, weight, sum);
  const Vec2 a = sum.by_a - size.by_a, b = sum.by_b - size.by_b;
  return {a.x, a.y, b.x, b.y};
}

const Eigen::Vector4d skew(2.1, -0.3, 0.9, 1.2);

TEST(SkewEnergy, OfRectanglesIsZeroWhateverTheirSidesAndSize) {
  EXPECT_NEAR(energy({1, 0, 0, 1}, 2), 0, 1e-14);
  EXPECT_NEAR(energy({0.3, 0.4, -40, 30}, 2), 0, 1e-14);
}

TEST(SkewEnergy, IsTheWeightAtASineOfFourFifthsAndSteepBelow) {
  const double rectangle = 2 * std::pow(0.8, 12);
  EXPECT_NEAR(energy({2, 0, 0.6, 0.8}, 2), 2 - rectangle, 1e-12);
  EXPECT_NEAR(energy({2, 0, std::sqrt(0.84), 0.4}, 2), 2 * std::pow(2, 12) - rectangle, 1e-8);
}

TEST(SkewEnergy, KeepsThinElementsUpright) {
  const Vec2 along{10, 0}, upright{0, 1}, leaning{1, 1};
  PointEnergy before(along, upright, 2), after(along, leaning, 2);
  EXPECT_LT(after.value, 1.1 * before.value) << "it is this term that does";
  const double least = after.value - before.value;
  add_skewness(along, leaning, 2, after);
  add_skewness(along, upright, 2, before);
  EXPECT_GT(after.value - before.value, least + 8);
}

TEST(SkewEnergy, DerivativesAreThoseOfDifferences) {
  const Eigen::Matrix4d hessian = skew_hessian({skew[0], skew[1]}, {skew[2], skew[3]}, 2);
  const double h = 1e-6;
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector4d d = h * Eigen::Vector4d::Unit(i);
    EXPECT_NEAR(gradient(skew, 2)[i], (energy(skew + d, 2) - energy(skew - d, 2)) / (2 * h), 1e-6);
    const Eigen::Vector4d column = (gradient(skew + d, 2) - gradient(skew - d, 2)) / (2 * h);
    EXPECT_LT((hessian.col(i) - column).norm(), 1e-6 * hessian.norm());
  }
}

TEST(SkewEnergy, BlocksAreTheHessianWithoutItsNegativeParts) {
  const double along_s = 0.7, along_t = -1.3;
  const std::array<double, 3> block = SkewBends({skew[0], skew[1]}, {skew[2], skew[3]}, 2).block(along_s, along_t);
  Eigen::Matrix<double, 4, 2> moves;
  moves << along_s, 0, 0, along_s, along_t, 0, 0, along_t;
  const Eigen::Matrix2d exact = moves.transpose() * skew_hessian({skew[0], skew[1]}, {skew[2], skew[3]}, 2) * moves;
  Eigen::Matrix2d positive;
  positive << block[0], block[1], block[1], block[2];
  EXPECT_GE((positive - exact).selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), -1e-9 * positive.norm());
  EXPECT_LT(positive.norm(), 1.5 * exact.norm());
}

}  // namespace
}  // namespace quadrille::refine
