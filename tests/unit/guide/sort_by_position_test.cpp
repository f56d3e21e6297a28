#include "guide/sort_by_position.hpp"

#include <gtest/gtest.h>

#include "base/vec2.hpp"

namespace quadrille::guide {
namespace {

std::vector<Vec2> sorted(std::vector<Vec2> points, double tol) {
  sort_by_position(points, tol, [](Vec2 x) { return x; });
  return points;
}

TEST(SortByPosition, GoesByXThenY) {
  EXPECT_EQ(sorted({{1, 0}, {0, 1}, {0, 0}}, 0), (std::vector<Vec2>{{0, 0}, {0, 1}, {1, 0}}));
}

TEST(SortByPosition, TakesXWithinTheToleranceAsEqual) {
  EXPECT_EQ(sorted({{0, 1}, {1e-9, 0}}, 1e-8), (std::vector<Vec2>{{1e-9, 0}, {0, 1}}));
  EXPECT_EQ(sorted({{0, 1}, {1e-9, 0}}, 1e-10), (std::vector<Vec2>{{0, 1}, {1e-9, 0}}));
}

}  // namespace
}  // namespace quadrille::guide
