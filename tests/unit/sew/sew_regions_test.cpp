#include "sew/sew_regions.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "regions.hpp"

namespace quadrille::sew {

namespace {

using namespace testing_regions;

const Nurbs& curve_of(const Sewn& sewn, CurveId id) { return sewn.regions[id.region].curves[id.curve].curve; }

/// That partners are partners of each other and the reverse of each other, bit for bit, and that loops are closed.
void expect_sewn(const Sewn& sewn, int num_interfaces) {
  int count = 0;
  for (int r = 0; r < static_cast<int>(sewn.regions.size()); ++r)
    for (int c = 0; c < sewn.regions[r].num_curves(); ++c) {
      const Nurbs& own = curve_of(sewn, {r, c});
      EXPECT_EQ(own.poles.back(), curve_of(sewn, {r, sewn.regions[r].next_in_loop(c)}).poles.front());
      const CurveId partner = sewn.partners[r][c];
      if (!partner.exists()) continue;
      ++count;
      EXPECT_EQ(sewn.partners[partner.region][partner.curve], (CurveId{r, c}));
      Nurbs other = curve_of(sewn, partner);
      std::reverse(other.poles.begin(), other.poles.end());
      std::reverse(other.weights.begin(), other.weights.end());
      EXPECT_EQ(own.poles, other.poles);
      EXPECT_EQ(own.weights, other.weights);
      for (std::size_t k = 0; k < own.knots.size(); ++k)
        EXPECT_NEAR(own.knots[k] - own.begin(), other.end() - other.knots[own.knots.size() - 1 - k], 1e-14);
    }
  EXPECT_EQ(count, 2 * num_interfaces);
  EXPECT_EQ(sewn.num_interfaces, num_interfaces);
}

TEST(SewRegions, TheCurveOfTheFirstRegionReplacesTheOther) {
  const Loop bulged{{curve::segment({1, 0}, {2, 0}), 0, ""},
                    {curve::segment({2, 0}, {2, 1}), 1, ""},
                    {curve::segment({2, 1}, {1, 1}), 2, ""},
                    {curve::circular_arc({1 + 1e5, 0.5}, 1e5, pi - 5e-6, pi + 5e-6), 3, ""}};
  const Sewn sewn = sew_regions(regions_of({{rectangle({0, 0}, {1, 1})}, {bulged}}), 1e-5);
  expect_sewn(sewn, 1);
  EXPECT_EQ(curve_of(sewn, {1, 3}).degree, 1);
  EXPECT_GT(sewn.greatest, 1e-7);
  EXPECT_LT(sewn.greatest, 2e-6);
}

TEST(SewRegions, TJointsSplitBothSidesAlike) {
  expect_sewn(sew_regions(regions_of({{rectangle({0, 0}, {2, 1})},
                                      {rectangle({0, 1}, {0.75, 2})},
                                      {rectangle({0.75, 1 + 1e-6}, {2, 2})}}),
                          1e-5),
              3);
}

TEST(SewRegions, EdgesThatOverlapInPartShareThatPart) {
  const Sewn sewn = sew_regions(regions_of({{rectangle({0, 0}, {2, 1})}, {rectangle({1, 1}, {3, 2})}}), 1e-5);
  expect_sewn(sewn, 1);
  EXPECT_EQ(sewn.partners[0][2], (CurveId{1, 0}));
  EXPECT_EQ(curve_of(sewn, {0, 2}).poles, (std::vector<Vec2>{{2, 1}, {1, 1}}));
}

TEST(SewRegions, ADiscInAHoleSharesTheCircleWhereverTheSeamsAre) {
  const Sewn sewn =
      sew_regions(regions_of({{rectangle({-2, -2}, {2, 2}), hole({0, 0}, 1)}, {circle({0, 0}, 1, 2)}}), 1e-5);
  expect_sewn(sewn, 1);
  EXPECT_NEAR(distance(curve_of(sewn, {1, 0}).poles.front(), {1, 0}), 0, 1e-15) << "the seam of the hole";
}

TEST(SewRegions, CurvesBetweenTheSamePlacesThatDifferAreNotShared) {
  const Loop disc{{curve::circular_arc({0, 0}, 1, -half_pi, half_pi), 0, ""},
                  {curve::circular_arc({0, 0}, 1, half_pi, 3 * half_pi), 1, ""}};
  const Loop beside = polygon({{0, -1}, {3, -1}, {3, 1}, {0, 1}});
  expect_sewn(sew_regions(regions_of({{disc}, {beside}}), 1e-5), 0);
}

TEST(SewRegions, ALayerThinnerThanTheToleranceKeepsItsTwoSides) {
  const Sewn sewn = sew_regions(regions_of({{circle({0, 0}, 1)},
                                            {rectangle({-2, -2}, {2, 2}), hole({0, 0}, 1 + 5e-6)},
                                            {circle({0, 0}, 1 + 5e-6), hole({0, 0}, 1)}}),
                                1e-5);
  expect_sewn(sewn, 2);
  EXPECT_EQ(sewn.partners[0][0], (CurveId{2, 1}));
  EXPECT_EQ(sewn.partners[1][4], (CurveId{2, 0}));
}

TEST(SewRegions, CurvesInTheSameDirectionAreNotShared) {
  expect_sewn(sew_regions(regions_of({{rectangle({0, 0}, {1, 1})}, {rectangle({0, 0}, {1, 1})}}), 1e-5), 0);
  expect_sewn(sew_regions(regions_of({{circle({0, 0}, 1)}, {circle({0, 0}, 1, 2)}}), 1e-5), 0);
}

TEST(SewRegions, FourRegionsMeetInOnePlace) {
  const Sewn sewn = sew_regions(regions_of({{rectangle({0, 0}, {1, 1})},
                                            {rectangle({1, 1e-6}, {2, 1})},
                                            {rectangle({0, 1}, {1 - 1e-6, 2})},
                                            {rectangle({1 + 1e-6, 1}, {2, 2})}}),
                                1e-5);
  expect_sewn(sewn, 4);
  EXPECT_EQ(sewn.places[0][2], sewn.places[1][3]);
  EXPECT_EQ(sewn.places[0][2], sewn.places[2][1]);
  EXPECT_EQ(sewn.places[0][2], sewn.places[3][0]);
}

TEST(SewRegions, SlitsKeepTheirOtherSide) {
  std::vector<Region> regions =
      regions_of({{rectangle({0, 0}, {1, 1})},
                  {polygon({{1 + 1e-6, 0}, {2, 0}, {2, 1}, {1.5, 1}, {1.5, 0.5}, {1.5, 1}, {1, 1}})}});
  regions[1].other_sides[3] = 4, regions[1].other_sides[4] = 3;
  const Sewn sewn = sew_regions(regions, 1e-5);
  EXPECT_EQ(sewn.num_interfaces, 1);
  EXPECT_EQ(sewn.partners[1][3], (CurveId{1, 4}));
  EXPECT_EQ(sewn.partners[1][4], (CurveId{1, 3}));
  EXPECT_EQ(sewn.places[1][3], sewn.places[1][5]) << "both sides of the end on the boundary are one place";
}

}  // namespace

}  // namespace quadrille::sew
