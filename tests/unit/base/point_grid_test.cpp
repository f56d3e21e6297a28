#include "base/point_grid.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace quadrille {
namespace {

constexpr auto all = [](int) { return true; };

std::vector<Vec2> random_points(int count, double width, double height) {
  std::mt19937 random(7);
  const auto below = [&](double most) { return most * static_cast<double>(random()) / 4294967296.0; };
  std::vector<Vec2> points;
  for (int n = 0; n < count; ++n) points.push_back({3 + below(width), below(height) - 5});
  return points;
}

PointGrid::Nearest nearest_of_all(const std::vector<Vec2>& points, Vec2 x) {
  PointGrid::Nearest best;
  for (int n = 0; n < static_cast<int>(points.size()); ++n)
    if (norm2(x - points[n]) < best.distance2) best = {n, norm2(x - points[n])};
  return best;
}

TEST(PointGrid, FindsThePointThatALoopOverAllFinds) {
  for (const Vec2 size : {Vec2{1, 1}, Vec2{100, 0.01}, Vec2{0, 2}, Vec2{1e-3, 50}}) {
    const PointGrid grid(random_points(200, size.x, size.y));
    // Inside, near and far away.
    for (const Vec2 x : random_points(100, 1.5 * size.x + 0.1, 1.5 * size.y + 0.1))
      for (const double away : {1.0, 30.0}) {
        const Vec2 at = away * x;
        const PointGrid::Nearest found = grid.nearest(at, all), expected = nearest_of_all(grid.points(), at);
        EXPECT_EQ(found.point, expected.point);
        EXPECT_EQ(found.distance2, expected.distance2);
      }
  }
}

TEST(PointGrid, OfEquallyNearPointsTheFirstIsFound) {
  std::vector<Vec2> points;
  for (int k = 0; k < 16; ++k) points.push_back({static_cast<double>(k % 4), static_cast<double>(k / 4)});
  const PointGrid grid(points);
  EXPECT_EQ(grid.nearest({1.5, 1.5}, all).point, 5);
  EXPECT_EQ(grid.nearest({1.5, 1.5}, [](int n) { return n != 5; }).point, 6);
  EXPECT_EQ(grid.nearest({2, 2}, [](int n) { return n > 10; }).point, 11);
  EXPECT_EQ(grid.nearest({2, 2}, [](int) { return false; }).point, -1);
}

TEST(PointGrid, WithoutPointsThereIsNoNearest) {
  EXPECT_EQ(PointGrid({}).nearest({1, 2}, all).point, -1);
  EXPECT_EQ(PointGrid({{1, 2}}).nearest({std::nan(""), 2}, all).point, -1);
}

TEST(PointGrid, VisitsAllPointsInABox) {
  const PointGrid grid(random_points(300, 2, 1));
  for (const Vec2 low : random_points(40, 2, 1))
    for (const double size : {0.0, 0.1, 0.7, 10.0}) {
      std::set<int> visited;
      grid.visit_box(low, low + Vec2{size, size}, [&](int n) { EXPECT_TRUE(visited.insert(n).second); });
      for (int n = 0; n < 300; ++n) {
        const Vec2 p = grid.points()[n];
        const bool is_in = p.x >= low.x && p.y >= low.y && p.x <= low.x + size && p.y <= low.y + size;
        EXPECT_TRUE(!is_in || visited.contains(n));
      }
    }
}

TEST(PlacesOf, AreTheLowestNumbersOfCoincidentPoints) {
  EXPECT_EQ(places_of({{1, 1}, {0, 0}, {1, 1}, {2, 0}, {1e-10, 0}}, 1e-9), (std::vector<int>{0, 1, 0, 3, 1}));
  EXPECT_TRUE(places_of({}, 1).empty());
}

}  // namespace
}  // namespace quadrille
