#include "triangulate/outline.hpp"

#include <gtest/gtest.h>

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

using namespace testing_faces;

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

}  // namespace
}  // namespace quadrille::triangulate
