#include "mesh/piecewise_polynomial.hpp"

#include <gtest/gtest.h>

namespace quadrille::mesh {
namespace {

TEST(PiecewisePolynomial, FollowsTheParabolaOfEachElement) {
  const PiecewisePolynomial y({0, 1, 2, 3, 4}, {0, 1, 4, 5, 4}, 2);  // x^2, then 5 - (x - 3)^2
  EXPECT_NEAR(y(0.5), 0.25, 1e-14);
  EXPECT_NEAR(y(1.5), 2.25, 1e-14);
  EXPECT_NEAR(y(2.5), 4.75, 1e-14);
  EXPECT_NEAR(y(4), 4, 1e-14);
}

}  // namespace
}  // namespace quadrille::mesh
