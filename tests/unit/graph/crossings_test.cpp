#include "graph/crossings.hpp"

#include <gtest/gtest.h>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/least_squares_spline.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::graph {
namespace {

Nurbs straight(Vec2 a, Vec2 b) {
  const double length = distance(a, b);
  return curve::cubic_spline({0, length / 3, length}, {a, a + (b - a) / 3, b}, (b - a) / length, (b - a) / length);
}

TEST(Crossings, TwoStraightLinesMeetOnce) {
  const auto found = find_crossings({straight({0, 0}, {4, 3}), straight({0, 3}, {4, 0})}, 1e-9);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT(distance(found[0].position, {2, 1.5}), 1e-14);
  EXPECT_NEAR(found[0].s, 2.5, 1e-13);
  EXPECT_NEAR(found[0].t, 2.5, 1e-13);
  EXPECT_NEAR(found[0].angle, pi - 2 * std::atan2(4, 3), 1e-12);
}

TEST(Crossings, LinesThatEndBeforeEachOtherDoNotMeet) {
  EXPECT_TRUE(find_crossings({straight({0, 0}, {1, 1}), straight({0, 3}, {1.4, 1.6})}, 1e-9).empty());
  EXPECT_TRUE(find_crossings({straight({0, 0}, {1, 0}), straight({0, 1e-6}, {1, 1e-6})}, 1e-9).empty());
}

TEST(Crossings, AWaveMeetsTheAxisAtEveryZero) {
  const curve::CurveFunction wave = [](double s, Vec2& d) {
    d = {1, std::cos(s)};
    return Vec2{s, std::sin(s)};
  };
  const double end = 6.5 * pi;
  const auto found = find_crossings({curve::fit_line(wave, end, 1e-10), straight({-1, 0}, {end, 0})}, 1e-9);
  // The seven zeros 0, pi, ... 6 pi.
  ASSERT_EQ(found.size(), 7u);
  for (int k = 0; k < 7; ++k) EXPECT_NEAR(found[k].position.x, k * pi, 1e-8);
}

TEST(Crossings, NearlyParallelCurvesCrossAsOftenAsTheyDo) {
  // Two circles of radius 1 and centres 1e-4 apart cross at right angles to the centres' line, at 1e-4 rad.
  const auto circle = [](Vec2 centre) {
    return curve::fit_line(
        [centre](double s, Vec2& d) {
          d = left_of(unit(s));
          return centre + unit(s);
        },
        2, 1e-12);
  };
  const auto found = find_crossings({circle({0, 0}), circle({1e-4, 0})}, 1e-9);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT(distance(found[0].position, {5e-5, std::sqrt(1 - 25e-10)}), 1e-7);
  EXPECT_NEAR(found[0].angle, 1e-4, 1e-7);
  // Concentric arcs never do, however near.
  const auto arc = [](double radius) {
    return curve::fit_line(
        [radius](double s, Vec2& d) {
          d = radius * left_of(unit(s));
          return radius * unit(s);
        },
        2, 1e-12);
  };
  EXPECT_TRUE(find_crossings({arc(1), arc(1 + 1e-6)}, 1e-9).empty());
}

TEST(Crossings, ALoopCrossesItself) {
  // The folium-like curve (s^2 - 1, s^3 - s) passes (0, 0) at s = -1 and s = 1, at right angles.
  const curve::CurveFunction loop = [](double u, Vec2& d) {
    const double s = u - 2;
    d = {2 * s, 3 * s * s - 1};
    return Vec2{s * s - 1, s * s * s - s};
  };
  const auto found = find_crossings({curve::fit_line(loop, 4, 1e-10)}, 1e-9);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT(norm(found[0].position), 1e-8);
  EXPECT_NEAR(found[0].s, 1, 1e-7);
  EXPECT_NEAR(found[0].t, 3, 1e-7);
  EXPECT_NEAR(found[0].angle, half_pi, 1e-6);
}

TEST(Crossings, ThroughACommonKnotCountsOnce) {
  // Both splines have a knot where they meet: four pairs of spans find the same place.
  const auto knotted = [](Vec2 a, Vec2 b) {
    return curve::cubic_spline({0, 1, 2}, {a, (a + b) / 2, b}, (b - a) / 2, (b - a) / 2);
  };
  EXPECT_EQ(find_crossings({knotted({-1, -1}, {1, 1}), knotted({-1, 1}, {1, -1})}, 1e-9).size(), 1u);
}

TEST(Crossings, ComeInTheSequenceOfTheFirstLine) {
  const auto found = find_crossings(
      {straight({0, 0}, {4, 0}), straight({3, -1}, {3, 1}), straight({1, -1}, {1, 1}), straight({2, -1}, {2, 1})},
      1e-9);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].b, 2);
  EXPECT_EQ(found[1].b, 3);
  EXPECT_EQ(found[2].b, 1);
}

// As a line does that passes a node at a millionth of its length: a quarter turn within that, across a long line
// that bends a little.
TEST(Crossings, ASharpBendAcrossALongLineIsFound) {
  const double scale = 1e-6;
  const curve::CurveFunction bend = [scale](double s, Vec2& d) {
    const double u = s - 0.7, root = std::hypot(u, scale);
    d = {1, -u / root};
    return Vec2{u, 2 * scale - root};
  };
  const curve::CurveFunction bow = [](double s, Vec2& d) {
    d = {s, 1};
    return Vec2{s * s / 2, s};
  };
  const auto found = find_crossings({curve::fit_line(bend, 1.5, 2e-9), curve::fit_line(bow, 1.5, 2e-9)}, 1e-9);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].t, scale, 0.1 * scale);
}

TEST(Crossings, TooManyPairsOfPiecesAreSaidWithAPlace) {
  // A comb: 20 lines across 20 lines are 400 pairs, and nothing but them is looked at.
  std::vector<Nurbs> lines;
  for (int i = 0; i < 20; ++i) {
    lines.push_back(straight({0, i + 0.5}, {20, i + 0.5}));
    lines.push_back(straight({i + 0.5, 0}, {i + 0.5, 20}));
  }
  EXPECT_EQ(find_crossings(lines, 1e-9).size(), 400u);
  CrossingBounds bounds;
  bounds.max_pairs = 300;
  CadFace face;
  face.origin = {1000, 0};
  bounds.face = &face;
  try {
    find_crossings(lines, 1e-9, bounds);
    FAIL();
  } catch (const ComputeError& error) {
    EXPECT_NE(std::string(error.what()).find("more than 300 pairs"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("(10"), std::string::npos) << error.what();
  }
}

TEST(Crossings, MoreThanTheBoundAreRefused) {
  const std::vector<Nurbs> lines{straight({0, 1}, {4, 1}), straight({0, 2}, {4, 2}), straight({1, 0}, {1, 3})};
  CrossingBounds bounds;
  bounds.max_crossings = 2;
  EXPECT_EQ(find_crossings(lines, 1e-9, bounds).size(), 2u);
  bounds.max_crossings = 1;
  EXPECT_THROW(find_crossings(lines, 1e-9, bounds), ComputeError);
}

TEST(Crossings, OnlyPairsWithAMarkedCurveAreSought) {
  const std::vector<Nurbs> lines{straight({0, 1}, {4, 1}), straight({0, 2}, {4, 2}), straight({1, 0}, {1, 3}),
                                 straight({2, 0}, {2, 3})};
  CrossingBounds bounds;
  bounds.sought = {false, true, false, false};
  const auto found = find_crossings(lines, 1e-9, bounds);
  ASSERT_EQ(found.size(), 2u);
  for (const Crossing& c : found) EXPECT_EQ(c.a, 1);
}

// Laps of one circle a snap distance apart cannot be told from each other: they do not cross, and that is found soon.
TEST(Crossings, LapsOfALimitCycleEndAtTheBound) {
  const curve::CurveFunction laps = [](double s, Vec2& d) {
    const double r = 1 + 1e-10 * s;
    d = 1e-10 * unit(s) + r * left_of(unit(s));
    return r * unit(s);
  };
  CrossingBounds bounds;
  bounds.max_pairs = 100000;
  EXPECT_THROW(find_crossings({curve::fit_line(laps, 200, 1e-11)}, 1e-9, bounds), ComputeError);
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

TEST(CrossingCache, AllItsSearchesTogetherAreBounded) {
  const std::vector<Nurbs> splines{row(1), row(2), column(3), column(4)};
  long long num_pairs = 0;
  CrossingBounds bounds;
  bounds.num_pairs = &num_pairs;
  find_crossings(splines, 1e-9, bounds);
  ASSERT_GT(num_pairs, 0);
  bounds.max_pairs = num_pairs;
  CrossingCache known;
  const auto search = [&](double n) { known.find({{n}, {n + 0.1}, {n + 0.2}, {n + 0.3}}, splines, 1e-9, bounds); };
  for (int i = 0; i < 4; ++i) EXPECT_NO_THROW(search(i)) << i;
  EXPECT_THROW(search(4), ComputeError);
}

}  // namespace
}  // namespace quadrille::graph
