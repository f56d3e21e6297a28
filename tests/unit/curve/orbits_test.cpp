#include "curve/orbits.hpp"

#include <gtest/gtest.h>

#include "base/angle.hpp"

namespace quadrille::curve {
namespace {

/// The symmetries of a rectangle about (0, 0).
const std::vector<Isometry> rectangle{{{0, 0}, 0, false}, {{0, 0}, pi, false}, {{0, 0}, 0, true}, {{0, 0}, pi, true}};

Orbits orbits_of(const std::vector<Vec2>& points, const std::vector<Isometry>& group = rectangle) {
  return orbits(points.size(), group,
                [&](const Isometry& g, int i, int j) { return distance(g(points[i]), points[j]) < 1e-9; });
}

TEST(Orbits, AreAscendingInTheOrderOfTheirFirstItems) {
  const Orbits result = orbits_of({{1, 0}, {2, 1}, {-1, 0}, {0, 0}, {2, -1}, {-2, 1}});
  EXPECT_EQ(result.sets, (std::vector<std::vector<int>>{{0, 2}, {1, 4, 5}, {3}}));
  EXPECT_EQ(result.first, (std::vector<int>{0, 1, 0, 3, 1, 1}));
}

TEST(Orbits, HaveMapsFromTheirFirstItems) {
  const std::vector<Vec2> points{{2, 1}, {-2, -1}, {2, -1}, {5, 5}};
  const Orbits result = orbits_of(points);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_NEAR(distance(result.map[i](points[result.first[i]]), points[i]), 0, 1e-14);
  EXPECT_EQ(result.map[0](points[0]), points[0]);
  EXPECT_TRUE(result.map[2].is_mirrored);
}

TEST(Orbits, HaveOneItemWithoutAnySymmetry) {
  EXPECT_EQ(orbits_of({{1, 0}, {-1, 0}}, {{{0, 0}, 0, false}}).sets, (std::vector<std::vector<int>>{{0}, {1}}));
  EXPECT_TRUE(orbits_of({}).sets.empty());
}

struct Place {
  Vec2 position;
  int kind = 0;
};

std::vector<int> images_of(const std::vector<Place>& places, const Isometry& isometry) {
  return images(places, isometry, 1e-6, [](const Place& a, const Place& b) { return a.kind == b.kind; });
}

TEST(Images, AreThoseOfTheSameKindWithinTheTolerance) {
  EXPECT_EQ(images_of({{{1, 0}}, {{5, 5}, 1}, {{-1, 1e-7}}, {{-5, -5}, 1}}, rectangle[1]),
            (std::vector<int>{2, 3, 0, 1}));
  EXPECT_TRUE(images_of({{{1, 0}}, {{-1, 1e-5}}}, rectangle[1]).empty());
  EXPECT_TRUE(images_of({{{1, 0}}, {{-1, 0}, 1}}, rectangle[1]).empty());
}

TEST(Images, AreOneToOneAndNearest) {
  EXPECT_EQ(images_of({{{2, 0}}, {{2, 0}}}, rectangle[2]), (std::vector<int>{0, 1}));
  EXPECT_EQ(images_of({{{2, 1e-8}}, {{2, -1e-8}}}, rectangle[2]), (std::vector<int>{1, 0}));
}

}  // namespace
}  // namespace quadrille::curve
