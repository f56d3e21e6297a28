#include "graph/crossing_cache.hpp"

#include <gtest/gtest.h>

#include "curve/nurbs.hpp"

namespace quadrille::graph {
namespace {

Nurbs straight(Vec2 a, Vec2 b) {
  const double length = distance(a, b);
  return curve::cubic_spline({0, length / 3, length}, {a, a + (b - a) / 3, b}, (b - a) / length, (b - a) / length);
}

Nurbs row(double y) { return straight({0, y}, {9, y}); }
Nurbs column(double x) { return straight({x, 0}, {x, 9}); }

TEST(CrossingCache, AreThoseOfANewSearchWhateverHasChanged) {
  CrossingCache known;
  const auto expect_all = [&](const std::vector<CurveKey>& keys, const std::vector<Nurbs>& splines) {
    const std::vector<Crossing>& found = known.find(keys, splines, 1e-9, {});
    const std::vector<Crossing> all = find_crossings(splines, 1e-9);
    ASSERT_EQ(found.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_EQ(found[i].a, all[i].a);
      EXPECT_EQ(found[i].b, all[i].b);
      EXPECT_EQ(found[i].s, all[i].s);
    }
  };
  expect_all({{0}, {1}, {2}, {3}}, {row(1), row(2), column(3), column(4)});
  expect_all({{0}, {5}, {2}, {3}}, {row(1), row(5), column(3), column(4)});  // one has changed
  expect_all({{5}, {3}}, {row(5), column(4)});                               // two have gone
  expect_all({{0}, {5}, {6}, {3}}, {row(1), row(5), column(6), column(4)});  // one is back, one is new
}

}  // namespace
}  // namespace quadrille::graph
