#include "layers/index_cubic.hpp"

#include <gtest/gtest.h>

#include "base/vec2.hpp"

namespace quadrille::layers {
namespace {

TEST(IndexCubic, IsExactForParabolasWithTheirDerivatives) {
  const auto parabola = [](double x) { return 1 + 2 * x - 0.5 * x * x; };
  std::vector<double> values;
  for (int k = 0; k < 5; ++k) values.push_back(parabola(k));
  for (const double x : {-0.5, 0.0, 0.3, 1.7, 3.9, 4.0, 4.5}) {
    EXPECT_NEAR(index_cubic(values, x).value, parabola(x), 1e-13) << x;
    EXPECT_NEAR(index_cubic(values, x).slope, 2 - x, 1e-13) << x;
    EXPECT_NEAR(index_cubic(values, x).bend, -1, 1e-12) << x;
  }
}

TEST(IndexCubic, IsLinearBetweenTwoPoints) {
  const IndexCubic<Vec2> at = index_cubic(std::vector<Vec2>{{0, 1}, {2, 5}}, 0.25);
  EXPECT_NEAR(distance(at.value, {0.5, 2}), 0, 1e-15);
  EXPECT_NEAR(distance(at.slope, {2, 4}), 0, 1e-15);
}

}  // namespace
}  // namespace quadrille::layers
