#include "sweep/terrain.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::sweep {
namespace {

double bicubic(double x, double y) { return (1 + x - x * x * x) * (2 - y * y + 0.5 * y * y * y); }

std::vector<Vec3> grid(const std::vector<double>& xs, const std::vector<double>& ys) {
  std::vector<Vec3> points;
  for (const double x : xs)
    for (const double y : ys) points.push_back({x, y, bicubic(x, y)});
  return points;
}

TEST(Terrain, IsABicubicThroughPointsOfOneInAnyOrder) {
  std::vector<Vec3> points = grid({0, 0.5, 1, 2}, {-1, 0, 0.25, 1, 2});
  std::reverse(points.begin(), points.end());
  std::swap(points[3], points[11]);
  const Terrain terrain(points, "h.csv");
  for (const Vec2 x : {Vec2{0, -1}, {0.2, 0.1}, {1.7, 1.9}, {2, 2}, {0.5, 0.6}})
    EXPECT_NEAR(terrain.height(x), bicubic(x.x, x.y), 1e-12);
}

TEST(Terrain, OfFourPointsIsBilinear) {
  const Terrain terrain({{0, 0, 0}, {2, 0, 2}, {0, 2, 4}, {2, 2, 10}}, "h.csv");
  EXPECT_NEAR(terrain.height({1, 1}), 4, 1e-14);
  EXPECT_NEAR(terrain.height({0.5, 1}), 0.75 * 2 + 0.25 * 6, 1e-14);
}

TEST(Terrain, RefusesWhatIsNoGridAndPlacesBeyondIt) {
  std::vector<Vec3> points = grid({0, 1, 2}, {0, 1});
  points.pop_back();
  const auto made = [&] { return Terrain(points, "h.csv"); };
  expect_contains(message_of<UsageError>(made), "h.csv: 5 points are no rectangular grid");
  points.push_back(points.front());  // six points, but one twice
  expect_contains(message_of<UsageError>(made), "3 different x and 2 different y");
  points = grid({0}, {0, 1, 2});
  expect_contains(message_of<UsageError>(made), "1 different x");
  const Terrain terrain(grid({0, 1}, {0, 1}), "h.csv");
  expect_contains(message_of<UsageError>([&] { terrain.height({1.1, 0.5}); }), "beyond its points, at (1.1, 0.5)");
}

}  // namespace
}  // namespace quadrille::sweep
