#include "galerkin/partial_cholesky.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quadrille::galerkin {
namespace {

Eigen::MatrixXd definite(int n) {
  Eigen::MatrixXd a(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) a(i, j) = (i == j ? n : 0) + std::cos(0.7 * i * j + i + j);
  }
  return a * a.transpose() / n;
}

Front front_of(const Eigen::MatrixXd& a, int k) {
  return {a.leftCols(k), a.bottomRightCorner(a.rows() - k, a.rows() - k)};
}

TEST(PartialCholesky, LeavesTheSchurComplement) {
  for (const int k : {0, 1, 40, 128, 200, 300}) {  // less and more than a block
    const int n = 300;
    const Eigen::MatrixXd a = definite(n);
    Front front = front_of(a, k);
    ASSERT_TRUE(eliminate(front, 1));
    Eigen::MatrixXd expected = a.bottomRightCorner(n - k, n - k);
    if (k > 0) expected -= a.bottomLeftCorner(n - k, k) * a.topLeftCorner(k, k).llt().solve(a.topRightCorner(k, n - k));
    const Eigen::MatrixXd error = (front.rest - expected).triangularView<Eigen::Lower>();
    EXPECT_LT(error.norm(), 1e-12 * a.norm()) << k;
    Eigen::MatrixXd l = front.panel;
    l.topRows(k).triangularView<Eigen::StrictlyUpper>().setZero();
    EXPECT_LT((l * l.topRows(k).transpose() - a.leftCols(k)).norm(), 1e-12 * a.norm()) << k;
  }
}

TEST(PartialCholesky, GivesTheSameBytesOnAnyNumberOfThreads) {
  const Eigen::MatrixXd a = definite(420);
  Front one = front_of(a, 270), three = one;
  ASSERT_TRUE(eliminate(one, 1) && eliminate(three, 3));
  const auto lower = [](const Eigen::MatrixXd& m) { return Eigen::MatrixXd(m.triangularView<Eigen::Lower>()); };
  EXPECT_TRUE(lower(one.panel) == lower(three.panel) && lower(one.rest) == lower(three.rest));
}

TEST(PartialCholesky, RefusesAnIndefiniteMatrix) {
  Eigen::MatrixXd a = definite(200);
  a(150, 150) = -1;
  Front inside = front_of(a, 160), outside = front_of(a, 140);
  EXPECT_FALSE(eliminate(inside, 1));
  EXPECT_TRUE(eliminate(outside, 1));  // what is not eliminated need not be definite
}

}  // namespace
}  // namespace quadrille::galerkin
