#include "features/boundary_clearance.hpp"

#include <gtest/gtest.h>

#include "feature_faces.hpp"

namespace quadrille::features {
namespace {

using namespace testing_features;

TEST(BoundaryClearance, IsTheDistanceToTheNearestCurve) {
  const CadFace face = plate(2, {round_hole({0, 0}, 0.5)});
  const BoundaryClearance clearance(face);
  EXPECT_NEAR(clearance.at({1.7, 0.3}), 0.3, 1e-14);
  EXPECT_NEAR(clearance.at({0.6, 0.8}), 0.5, 1e-12);
}

TEST(BoundaryClearance, IsThatOfAnotherCurveThanTheOneWhoseBoxIsNearest) {
  const CadFace face = plate(0.6, {round_hole({0, 0}, 0.5)});
  EXPECT_NEAR(BoundaryClearance(face).at({0.49, 0.49}), 0.11, 1e-14);
}

TEST(BoundaryClearance, HasOneFootOnEachCurveInReach) {
  const CadFace face = plate(2);
  const BoundaryClearance clearance(face);
  EXPECT_TRUE(clearance.feet({0, 0}, 2).empty());  // nearer than the reach, not as near
  EXPECT_EQ(clearance.feet({0, 0}, 2.1).size(), 4u);
  EXPECT_EQ(clearance.feet({1.8, 0}, 1).size(), 1u);
}

TEST(BoundaryClearance, CountsACornerThatTwoCurvesShareOnce) {
  const CadFace face = plate(4, {window({-1, -1}, {1, 1}, 0)});
  const std::vector<CurveFoot> feet = BoundaryClearance(face).feet({1.3, 1.4}, 1);
  ASSERT_EQ(feet.size(), 1u);
  EXPECT_NEAR(distance(feet[0].position, {1, 1}), 0, 1e-12);
  EXPECT_TRUE(feet[0].is_reflex);
}

TEST(BoundaryClearance, KnowsWhereTheBoundaryTurnsAway) {
  const CadFace face = plate(4, {window({-1, -1}, {1, 1}, 0.2)});
  const BoundaryClearance clearance(face);
  const auto count_reflex = [&](Vec2 x) {
    const std::vector<CurveFoot> feet = clearance.feet(x, 0.25);
    return std::count_if(feet.begin(), feet.end(), [](const CurveFoot& foot) { return foot.is_reflex; });
  };
  EXPECT_EQ(count_reflex({1.1, 1.1}), 1);   // before a fillet
  EXPECT_EQ(count_reflex({1.2, 0.85}), 2);  // before its end: the fillet and the end of the straight side
  EXPECT_EQ(count_reflex({1.2, 0}), 0);     // before a straight side
  EXPECT_EQ(count_reflex({3.9, 3.9}), 0);   // in a convex corner
}

TEST(BoundaryClearance, SeesAlongSegmentsThatStayInside) {
  const CadFace face = plate(2, {round_hole({0, 0}, 0.5)});
  const BoundaryClearance clearance(face);
  EXPECT_TRUE(clearance.is_segment_inside({-1, 0.6}, {1, 0.6}));
  EXPECT_FALSE(clearance.is_segment_inside({-1, 0.4}, {1, 0.4}));
}

}  // namespace
}  // namespace quadrille::features
