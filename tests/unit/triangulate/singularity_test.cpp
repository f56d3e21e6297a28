#include "triangulate/singularity.hpp"

#include <gtest/gtest.h>

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
  // ln(1e-10) / (2 alpha ln 0.15): 9.1, 4.6, 11.6
  EXPECT_EQ(layers(corner(270)), 9);
  EXPECT_EQ(layers(corner(135)), 5);
  EXPECT_EQ(layers(corner(343)), 12);
}

TEST(Singularity, ACurvedSideOfARightAngleGivesALogarithmOfSecondOrder) {
  EXPECT_EQ(junction_singularity(corner(90, 0, 1), 0.5).exponent, 2);
  EXPECT_EQ(layers(corner(90, 0, 1)), 3);
  EXPECT_EQ(layers(corner(90, 1, 0)), 3);
}

TEST(Singularity, ACurvatureJumpGivesALogarithmOfFirstOrder) {
  EXPECT_EQ(junction_singularity(corner(180, 0, 1), 0.5).exponent, 1);
  EXPECT_EQ(layers(corner(180, 0, 1)), 6);
  EXPECT_EQ(layers(corner(180, 1, 1)), 0);
}

TEST(Singularity, WeakJumpsNeedFewerLayersOrNone) {
  EXPECT_LT(layers(corner(180, 1, 1.05)), layers(corner(180, 0, 1)));
  EXPECT_EQ(layers(corner(180, 1, 1 + 1e-4)), 0);
}

TEST(Singularity, AnglesOffByRoundingAreTheirNeighbours) { EXPECT_EQ(layers(corner(90 + 1e-6)), 0); }

TEST(Singularity, ASmallerFactorNeedsFewerLayers) {
  const Singularity reflex = junction_singularity(corner(270), 0.5);
  EXPECT_LT(fan_layers(reflex, 0.1), fan_layers(reflex, 0.3));
}

}  // namespace
}  // namespace quadrille::triangulate
