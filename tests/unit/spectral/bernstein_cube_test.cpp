#include "spectral/bernstein_cube.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace quadrille::spectral {
namespace {

TEST(BernsteinCube, BoundIsSharpenedByBisection) {
  // 4 (x - 1/2)^2 + 1/8 on [0, 1], constant in y and z: coefficients 9/8, -7/8, 9/8.
  BernsteinCube p{2, {}, 0};
  for (int line = 0; line < 9; ++line) p.coefs.insert(p.coefs.end(), {9.0 / 8, -7.0 / 8, 9.0 / 8});
  EXPECT_LT(lower_bound(p, 0), 0);
  EXPECT_GT(lower_bound(p, 2), 0);
  EXPECT_LE(lower_bound(p, 2), 1.0 / 8);
  p.error = 0.2;
  EXPECT_LE(lower_bound(p, 4), 0);
}

/// xi2 xi3 - 1/8 with an error: a corner value that is negative ends the work.
TEST(BernsteinCube, ANegativeCornerIsNotBisected) {
  const BernsteinCube product{1, {0, 0, 0, 0, 0, 0, 1, 1}, 0};  // xi2 xi3
  EXPECT_EQ(lower_bound(product, 30), 0) << "after one step: eight to the power of 30 parts would not end";
  BernsteinCube shifted = product;
  for (double& c : shifted.coefs) c -= 0.125;
  EXPECT_EQ(lower_bound(shifted, 30), -0.125);
}

TEST(BernsteinCube, DirectionsCountAlike) {
  // 4 (x - 1/2)^2 + 1/8 along each direction in turn.
  const std::array<double, 3> line{9.0 / 8, -7.0 / 8, 9.0 / 8};
  std::array<double, 3> bounds{};
  for (int direction = 0; direction < 3; ++direction) {
    BernsteinCube p{2, {}, 0};
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) p.coefs.push_back(line[direction == 0 ? i : direction == 1 ? j : k]);
    bounds[direction] = lower_bound(p, 3);
  }
  EXPECT_GT(bounds[0], 0);
  EXPECT_EQ(bounds[1], bounds[0]);
  EXPECT_EQ(bounds[2], bounds[0]);
}

TEST(BernsteinCube, AConstantIsItsOwnBoundLessTheError) {
  EXPECT_EQ(lower_bound({1, std::vector<double>(8, 0.5), 0.125}, 5), 0.375);
  EXPECT_EQ(lower_bound({1, std::vector<double>(8, 0.5), 0.75}, 5), -0.25);
}

}  // namespace
}  // namespace quadrille::spectral
