#include "triangulate/singularity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"

namespace quadrille::triangulate {
namespace {

Junction corner(double angle_degrees, double curvature_in = 0, double curvature_out = 0) {
  Junction junction;
  junction.interior_angle = radians(angle_degrees);
  junction.curvature_in = curvature_in;
  junction.curvature_out = curvature_out;
  return junction;
}

int layers(const Junction& junction) { return fan_layers(junction_singularity(junction, 0.5), 0.15); }

TEST(Singularity, StraightSidesAtPartsOfPiAreSmooth) {
  for (const double angle : {30.0, 36.0, 45.0, 60.0, 90.0, 180.0}) EXPECT_EQ(layers(corner(angle)), 0) << angle;
}

TEST(Singularity, OtherAnglesHaveTheExponentPiByOmega) {
  EXPECT_NEAR(junction_singularity(corner(270), 0.5).exponent, 2.0 / 3, 1e-14);
  EXPECT_NEAR(junction_singularity(corner(135), 0.5).exponent, 4.0 / 3, 1e-14);
  // ln(1e-10 * 8^(4 alpha)) / (2 alpha ln 0.15): 6.9, 2.4, 9.4
  EXPECT_EQ(layers(corner(270)), 7);
  EXPECT_EQ(layers(corner(135)), 2);
  EXPECT_EQ(layers(corner(343)), 9);
}

TEST(Singularity, ACurvedSideOfARightAngleGivesALogarithmOfSecondOrder) {
  EXPECT_EQ(junction_singularity(corner(90, 0, 1), 0.5).exponent, 2);
  EXPECT_EQ(layers(corner(90, 0, 1)), 1);
  EXPECT_EQ(layers(corner(90, 1, 0)), 1);
}

TEST(Singularity, ACurvatureJumpGivesALogarithmOfFirstOrder) {
  EXPECT_EQ(junction_singularity(corner(180, 0, 1), 0.5).exponent, 1);
  EXPECT_EQ(layers(corner(180, 0, 1)), 4);
  EXPECT_EQ(layers(corner(180, 1, 1)), 0);
}

TEST(Singularity, WeakJumpsNeedFewerLayersOrNone) {
  EXPECT_LT(layers(corner(180, 1, 1.05)), layers(corner(180, 0, 1)));
  EXPECT_EQ(layers(corner(180, 1, 1 + 1e-4)), 0);
}

Junction knot(double slope_in, double slope_out) {
  Junction junction = corner(180, 1, 1);
  junction.curvature_slope_in = slope_in;
  junction.curvature_slope_out = slope_out;
  return junction;
}

TEST(Singularity, EdgesAtAKnotHaveALengthThatFallsWithTheRootOfItsJump) {
  const double length = greatest_edge_length(knot(1, 2));
  EXPECT_TRUE(std::isfinite(length));
  EXPECT_EQ(greatest_edge_length(knot(2, 1)), length);
  EXPECT_NEAR(greatest_edge_length(knot(-2, 2)), length / 2, 1e-15);
}

TEST(Singularity, AKnotOfTwiceTheSizeHasEdgesOfTwiceTheLength) {
  EXPECT_NEAR(greatest_edge_length(knot(1, 1.25)), 2 * greatest_edge_length(knot(4, 5)), 1e-15);
}

TEST(Singularity, EdgesHaveAnyLengthWhereNothingJumpsAndAtCorners) {
  EXPECT_TRUE(std::isinf(greatest_edge_length(knot(2, 2))));
  Junction right_angle = knot(1, 2);
  right_angle.interior_angle = pi / 2;
  EXPECT_TRUE(std::isinf(greatest_edge_length(right_angle)));
}

TEST(Singularity, BetweenEdgesOfTheGreatestLengthThereIsNoFan) {
  const Junction junction = knot(0, 1);
  const double radius = greatest_edge_length(junction) / 3;  // of a fan, at most
  EXPECT_EQ(fan_layers(junction_singularity(junction, radius), 0.15), 0);
}

TEST(Singularity, NoOrderResolvesABridge) {
  Junction bend = corner(150);
  bend.has_bridge = true;
  // ln(1e-10) / (2 * 1.2 * ln 0.15)
  EXPECT_EQ(layers(bend), 5);
}

TEST(Singularity, AnglesOffByRoundingAreTheirNeighbours) { EXPECT_EQ(layers(corner(90 + 1e-6)), 0); }

TEST(Singularity, ASmallerFactorNeedsFewerLayers) {
  const Singularity reflex = junction_singularity(corner(270), 0.5);
  EXPECT_LT(fan_layers(reflex, 0.1), fan_layers(reflex, 0.3));
}

}  // namespace
}  // namespace quadrille::triangulate
