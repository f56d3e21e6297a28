#include "sew/region.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "regions.hpp"

namespace quadrille::sew {

namespace {

using namespace testing_regions;

TEST(Places, JointsWithinTheToleranceAreOnePlaceWhereTheFirstRegionHasIt) {
  const Placed placed =
      split_at_places(regions_of({{rectangle({0, 0}, {1, 1})}, {rectangle({1 + 4e-6, 3e-6}, {2, 1})}}), 1e-5);
  EXPECT_EQ(placed.positions.size(), 6U);
  EXPECT_EQ(placed.places[1][0], placed.places[0][1]);
  EXPECT_EQ(placed.positions[placed.places[1][0]], (Vec2{1, 0}));
  EXPECT_NEAR(placed.greatest, 5e-6, 1e-15);
}

TEST(Places, JointsFartherApartAreTwo) {
  const Placed placed =
      split_at_places(regions_of({{rectangle({0, 0}, {1, 1})}, {rectangle({1.00002, 0}, {2, 1})}}), 1e-5);
  EXPECT_EQ(placed.positions.size(), 8U);
  EXPECT_EQ(placed.greatest, 0);
}

TEST(Places, TwoJointsOfOneRegionAreNeverOnePlace) {
  const Loop narrow = polygon({{1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 1e-6}});
  const Placed placed = split_at_places(regions_of({{rectangle({0, 0}, {1, 1})}, {narrow}}), 1e-5);
  EXPECT_EQ(placed.places[1][0], placed.places[0][1]) << "the nearest";
  EXPECT_NE(placed.places[1][4], placed.places[0][1]);
}

TEST(Places, AJointOnTheEdgeOfANeighbourSplitsIt) {
  const Placed placed = split_at_places(
      regions_of({{rectangle({0, 0}, {2, 1})}, {rectangle({0, 1}, {0.75, 2})}, {rectangle({0.75, 1 + 1e-6}, {2, 2})}}),
      1e-5);
  ASSERT_EQ(placed.regions[0].num_curves(), 5);
  EXPECT_EQ(placed.regions[1].num_curves(), 4);
  const int place = placed.places[0][3];
  EXPECT_EQ(placed.positions[place], (Vec2{0.75, 1})) << "on the edge of the first region";
  EXPECT_EQ(placed.places[1][1], place);
  EXPECT_EQ(placed.places[2][0], place);
  EXPECT_EQ(placed.regions[0].curves[3].cad_edge, 2);
}

TEST(Places, AJointJustBesideAnotherSplitsNothing) {
  const Placed placed =
      split_at_places(regions_of({{rectangle({0, 0}, {1, 1})}, {rectangle({0, 1}, {1 - 1.5e-5, 2})}}), 1e-5);
  EXPECT_EQ(placed.regions[0].num_curves(), 4) << "a piece would be hardly longer than the tolerance";
}

TEST(Places, ASmoothClosedCurveHasNoPlaces) {
  const Placed placed =
      split_at_places(regions_of({{circle({0, 0}, 2), hole({0, 0}, 1)}, {circle({0, 0}, 1, 2)}}), 1e-5);
  EXPECT_TRUE(placed.positions.empty());
  EXPECT_EQ(placed.regions[0].num_curves(), 2);
}

// A circle in whose hole two half discs lie: their corners are the only places.
TEST(Places, ASmoothClosedCurveIsSplitAtTheJointsOfOthersAlone) {
  const Loop upper{{curve::segment({-1, 0}, {1, 0}), 0, ""}, {curve::circular_arc({0, 0}, 1, 0, pi), 1, ""}};
  const Loop lower{{curve::segment({1, 0}, {-1, 0}), 0, ""}, {curve::circular_arc({0, 0}, 1, pi, 2 * pi), 1, ""}};
  for (const double seam : {0.0, 1.0, pi}) {
    const Placed placed =
        split_at_places(regions_of({{circle({0, 0}, 2), hole({0, 0}, 1, seam)}, {upper}, {lower}}), 1e-5);
    EXPECT_EQ(placed.positions.size(), 2U);
    ASSERT_EQ(placed.regions[0].num_curves(), 3) << seam;
    EXPECT_EQ(placed.regions[0].loop_offsets, (std::vector<int>{0, 1, 3}));
    for (const int c : {1, 2}) {
      const Nurbs& half = placed.regions[0].curves[c].curve;
      EXPECT_NEAR(std::abs(half.poles.front().x - half.poles.back().x), 2, 1e-14);
      EXPECT_NEAR(half.poles.front().y, 0, 1e-14);
    }
  }
}

TEST(Places, CurvesAreMovedToTheirPlaces) {
  const Placed placed =
      split_at_places(regions_of({{rectangle({0, 0}, {1, 1})}, {rectangle({1 + 4e-6, 3e-6}, {2, 1})}}), 1e-5);
  const Nurbs left = curve_to_places(placed, {1, 3});
  EXPECT_EQ(left.poles, (std::vector<Vec2>{{1, 1}, {1, 0}}));
  EXPECT_EQ(curve_to_places(placed, {0, 3}).poles, placed.regions[0].curves[3].curve.poles);
}

}  // namespace

}  // namespace quadrille::sew
