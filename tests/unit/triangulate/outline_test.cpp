#include "triangulate/outline.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"
#include "faces.hpp"

namespace quadrille::triangulate {
namespace {

using namespace testing_faces;

TEST(Outline, HalfDiscHasTwoPiecesAndTwoRightAngles) {
  const CadFace face = half_disc();
  const Outline outline(face, 1e-13);
  ASSERT_EQ(outline.pieces().size(), 2u);
  EXPECT_TRUE(outline.pieces()[0].is_straight);
  EXPECT_FALSE(outline.pieces()[1].is_straight);
  EXPECT_NEAR(outline.pieces()[1].length(), pi, 1e-13);
  for (const Junction& junction : outline.junctions()) EXPECT_NEAR(junction.interior_angle, half_pi, 1e-14);
  EXPECT_EQ(outline.junctions()[1].curvature_in, 0);
  EXPECT_NEAR(outline.junctions()[1].curvature_out, 1, 1e-13);
  EXPECT_NEAR(outline.junctions()[0].curvature_in, 1, 1e-13);
}

TEST(Outline, PiecesAreLinkedLoopByLoop) {
  const CadFace face = make_face({polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), hole({2, 2}, 1)});
  const Outline outline(face, 1e-13);
  ASSERT_EQ(outline.pieces().size(), 5u);
  EXPECT_EQ(outline.pieces()[3].next, 0);
  EXPECT_EQ(outline.pieces()[0].previous, 3);
  EXPECT_EQ(outline.pieces()[4].next, 4);
  EXPECT_EQ(outline.pieces()[4].previous, 4);
}

TEST(Outline, AKnotOfACubicSplineDividesIt) {
  Loop loop{curve::cubic_spline({0, 1, 2}, {{0, 0}, {1, -0.5}, {2, 0}}, {1, -2}, {1, 2}),
            curve::segment({2, 0}, {1, 3}), curve::segment({1, 3}, {0, 0})};
  const CadFace face = make_face({loop});
  const Outline outline(face, 1e-13);
  ASSERT_EQ(outline.pieces().size(), 4u);
  EXPECT_EQ(outline.pieces()[0].t1, 1);
  EXPECT_EQ(outline.junctions()[1].interior_angle, pi);
  EXPECT_NEAR(outline.junctions()[1].curvature_in, outline.junctions()[1].curvature_out, 1e-12);
  EXPECT_GT(std::abs(outline.junctions()[1].curvature_slope_in - outline.junctions()[1].curvature_slope_out), 1e-3);
}

TEST(Outline, AStraightCurveOfHigherDegreeIsStraight) {
  Nurbs line{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0}, {0.1, 0}, {0.9, 0}, {1, 0}}, {1, 1, 1, 1}};
  const CadFace face = make_face({{line, curve::segment({1, 0}, {0.5, 1}), curve::segment({0.5, 1}, {0, 0})}});
  EXPECT_TRUE(Outline(face, 1e-13).pieces()[0].is_straight);
}

TEST(Outline, ACurveThatReturnsOnItsOwnLineIsNotStraight) {
  Nurbs line{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0}, {2, 0}, {0.9, 0}, {1, 0}}, {1, 1, 1, 1}};
  const CadFace face = make_face({{line, curve::segment({1, 0}, {0.5, 1}), curve::segment({0.5, 1}, {0, 0})}});
  EXPECT_FALSE(Outline(face, 1e-13).pieces()[0].is_straight);
}

TEST(Clearance, OfASquaresCornerIsTheWayToTheSidesThatDoNotStartThere) {
  const CadFace face = square();
  const Outline outline(face, 1e-13);
  const Clearance clearance(outline);
  for (int j = 0; j < 4; ++j) EXPECT_NEAR(clearance.at_junction(j), 1, 1e-15);
}

TEST(Clearance, SeesAHoleBesideTheCorner) {
  const CadFace face = make_face({polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), hole({0.5, 0.5}, 0.25)});
  const Outline outline(face, 1e-13);
  EXPECT_NEAR(Clearance(outline).at_junction(0), std::sqrt(0.5) - 0.25, 0.003);
}

TEST(Clearance, SeesTheSameCurveComeBack) {
  // A needle's eye: the arc leaves the corner and returns close to it.
  const double gap = 0.1;
  const Loop loop{curve::circular_arc({0, 0}, 1, gap, 2 * pi - gap), curve::segment(unit(2 * pi - gap), {3, -gap}),
                  curve::segment({3, -gap}, {3, gap}), curve::segment({3, gap}, unit(gap))};
  const CadFace face = make_face({loop});
  const Outline outline(face, 1e-13);
  EXPECT_NEAR(Clearance(outline).at_junction(0), 2 * std::sin(gap), 1e-9);
}

TEST(Clearance, ACurveThatClosesAtTheJunctionIsNoObstacle) {
  // A slit joins two whole circles of radii 1 and 0.5.
  const CadFace face = cut_annulus();
  const Outline outline(face, 1e-13);
  for (int j = 0; j < 4; ++j) EXPECT_NEAR(Clearance(outline).at_junction(j), 0.5, 1e-3) << j;
}

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
