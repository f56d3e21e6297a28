#include "sew/embed_curves.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.hpp"
#include "outline/extent.hpp"
#include "regions.hpp"

namespace quadrille::sew {
namespace {

using namespace testing_regions;

heal::LoopCurve line(Vec2 a, Vec2 b) { return {curve::segment(a, b), 7, "inner"}; }

Region square() { return region_of({rectangle({0, 0}, {2, 2})}, "plate", 0); }

std::vector<Region> embedded(const std::vector<heal::LoopCurve>& curves, const Region& region = square()) {
  return embed_curves(region, curves, 1e-5, "x.step");
}

double area_of(const Region& region) {
  double area = 0;
  for (const auto& loop : loop_curves(region)) area += outline::signed_area(loop);
  return area;
}

int num_slit_sides(const Region& region) {
  int sides = 0;
  for (int c = 0; c < region.num_curves(); ++c) {
    const int other = region.other_sides[c];
    if (other < 0) continue;
    ++sides;
    EXPECT_EQ(region.other_sides[other], c);
    EXPECT_TRUE(std::equal(region.curves[c].curve.poles.begin(), region.curves[c].curve.poles.end(),
                           region.curves[other].curve.poles.rbegin(), region.curves[other].curve.poles.rend()));
  }
  for (int c = 0; c < region.num_curves(); ++c)
    EXPECT_EQ(region.curves[c].curve.poles.back(), region.curves[region.next_in_loop(c)].curve.poles.front());
  return sides;
}

TEST(EmbedCurves, ACurveInsideIsALoopOfItsOwn) {
  const std::vector<Region> regions = embedded({line({0.5, 1}, {1.5, 1})});
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].loop_offsets, (std::vector<int>{0, 4, 6}));
  EXPECT_EQ(num_slit_sides(regions[0]), 2);
  EXPECT_EQ(regions[0].curves[4].name, "inner");
  EXPECT_EQ(regions[0].curves[4].cad_edge, 7);
}

TEST(EmbedCurves, ACurveFromTheBoundarySplitsIt) {
  const std::vector<Region> regions = embedded({line({1, 4e-6}, {1, 1})});
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].num_loops(), 1);
  EXPECT_EQ(regions[0].num_curves(), 7);
  EXPECT_EQ(num_slit_sides(regions[0]), 2);
  EXPECT_EQ(regions[0].curves[1].curve.poles.front(), (Vec2{1, 0})) << "the end is moved to the boundary";
}

TEST(EmbedCurves, ACurveAcrossMakesTwoRegionsOfOneName) {
  const std::vector<Region> regions = embedded({line({0.5, 0}, {0.5, 2})});
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_EQ(regions[1].name, "plate");
  EXPECT_NEAR(std::min(area_of(regions[0]), area_of(regions[1])), 1, 1e-14);
  EXPECT_NEAR(std::max(area_of(regions[0]), area_of(regions[1])), 3, 1e-14);
  EXPECT_EQ(num_slit_sides(regions[0]) + num_slit_sides(regions[1]), 0);
}

TEST(EmbedCurves, BranchesAndCrossingsAreOneLoopAround) {
  const std::vector<Region> cross = embedded({line({0.5, 1}, {1.5, 1}), line({1, 0.5}, {1, 1.5})});
  ASSERT_EQ(cross.size(), 1U);
  EXPECT_EQ(cross[0].loop_offsets, (std::vector<int>{0, 4, 12}));
  EXPECT_EQ(num_slit_sides(cross[0]), 8);
  const std::vector<Region> branch = embedded({line({0.5, 1}, {1.5, 1}), line({1, 1 + 3e-6}, {1, 1.5})});
  ASSERT_EQ(branch.size(), 1U);
  EXPECT_EQ(branch[0].loop_offsets, (std::vector<int>{0, 4, 10}));
}

TEST(EmbedCurves, AClosedCurveHasARegionInside) {
  const std::vector<Region> regions = embedded({circle({1, 1}, 0.5)[0]});
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_EQ(regions[0].num_loops(), 2);
  EXPECT_NEAR(area_of(regions[0]), 4 - pi / 4, 1e-12);
  EXPECT_NEAR(area_of(regions[1]), pi / 4, 1e-12);
}

TEST(EmbedCurves, AClosedCurveOfSegmentsWithACurveInside) {
  const std::vector<Region> regions =
      embedded({line({0.5, 0.5}, {1.5, 0.5}), line({1.5, 0.5}, {1, 1.5}), line({1, 1.5}, {0.5, 0.5}),
                line({0.9, 0.7}, {1.1, 0.7}), line({0.1, 1.8}, {0.3, 1.8})});
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_NEAR(area_of(regions[1]), 0.5, 1e-14);
  EXPECT_EQ(regions[0].num_loops(), 3);
  EXPECT_EQ(regions[1].num_loops(), 2);
  EXPECT_EQ(num_slit_sides(regions[1]), 2);
}

TEST(EmbedCurves, ACurveBetweenHoleAndOutlineJoinsTheirLoops) {
  const Region plate = region_of({rectangle({0, 0}, {2, 2}), hole({1, 1}, 0.5)}, "plate", 0);
  const std::vector<Region> regions = embedded({line({1.5, 1}, {2, 1})}, plate);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].num_loops(), 1);
  EXPECT_NEAR(area_of(regions[0]), 4 - pi / 4, 1e-12);
  EXPECT_EQ(num_slit_sides(regions[0]), 2);
}

TEST(EmbedCurves, PartsOutsideTheRegionAndAlongItsBoundaryAreLeftOut) {
  const std::vector<Region> regions = embedded({line({1, 1}, {3, 1})});
  EXPECT_EQ(num_slit_sides(regions[0]), 2);
  EXPECT_EQ(regions[0].num_loops(), 1);
  EXPECT_EQ(regions[0].num_curves(), 7);
  const std::vector<Region> along = embedded({line({0.5, 0}, {1.5, 0})});
  ASSERT_EQ(along.size(), 1U);
  EXPECT_EQ(along[0].num_curves(), 4) << "nothing is split";
  EXPECT_EQ(along[0].curves[0].curve.poles, (std::vector<Vec2>{{0, 0}, {2, 0}}));
  const std::vector<Region> outside = embedded({line({3, 1}, {4, 1})});
  ASSERT_EQ(outside.size(), 1U);
  EXPECT_EQ(outside[0].num_curves(), 4);
  EXPECT_EQ(num_slit_sides(embedded({line({0.5, 1}, {1.5, 1}), line({0.5, 1 + 1e-6}, {1.5, 1})})[0]), 2) << "once";
  const heal::LoopCurve arc{curve::circular_arc({1, 1}, 0.5, 0, 2), 5, ""};
  EXPECT_EQ(num_slit_sides(embedded({arc, arc})[0]), 2);
}

TEST(EmbedCurves, WhereCurvesLieUponEachOtherTheShorterOneGivesTheName) {
  const heal::LoopCurve along{curve::segment({0.2, 1}, {1.8, 1}), 5, "long"}, part = line({1.2, 1}, {0.8, 1});
  for (const auto& curves : {std::vector{along, part}, std::vector{part, along}}) {
    const Region region = embedded(curves)[0];
    ASSERT_EQ(num_slit_sides(region), 6);
    for (int c = 4; c < region.num_curves(); ++c) {
      const bool is_part =
          std::abs(curve::point(region.curves[c].curve, 0.5 * region.curves[c].curve.end()).x - 1) < 0.1;
      EXPECT_EQ(region.curves[c].name, is_part ? "inner" : "long");
      EXPECT_EQ(region.curves[c].cad_edge, is_part ? 7 : 5);
    }
  }
}

TEST(EmbedCurves, ACurveMayEndWhereTheRegionTouchesItself) {
  heal::Loop loop;
  const std::vector<Vec2> corners{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 2}, {2, 1}};
  for (size_t i = 0; i < corners.size(); ++i) {
    const Vec2 a = corners[i], b = corners[(i + 1) % corners.size()];
    loop.push_back({curve::segment(a, b), static_cast<int>(i), ""});
  }
  const std::vector<Region> regions = embedded({line({3, 0.2}, {0, 0})}, region_of({loop}, "plate", 0));
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(num_slit_sides(regions[0]), 2);
  EXPECT_EQ(regions[0].num_curves(), 9);
  EXPECT_EQ(regions[0].num_loops(), 1);
}

TEST(EmbedCurves, AnglesOfZeroAreRefused) {
  const heal::LoopCurve tangent{curve::circular_arc({1, 1}, 1, -half_pi, -0.5), 5, ""};
  try {
    embedded({tangent});
    FAIL();
  } catch (const FormatError& e) {
    EXPECT_NE(std::string(e.what()).find("edges 0 and 5 touch or run along each other at (1, 0)"), std::string::npos)
        << e.what();
  }
}

}  // namespace
}  // namespace quadrille::sew
