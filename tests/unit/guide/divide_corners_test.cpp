#include "guide/divide_corners.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/critical_points.hpp"
#include "../triangulate/faces.hpp"
#include "base/angle.hpp"

namespace quadrille::guide {
namespace {

using namespace testing_faces;
using hand_made::points_of;

/// Its sharp corner at the origin, the bisector along x.
CadFace kite(double angle) {
  const double h = 4 * std::tan(angle / 2);
  return make_face({polygon({{0, 0}, {4, -h}, {5, 0}, {4, h}})});
}

TEST(DivideCorners, ASharpCornerGetsANodeOnItsBisectorAndKeepsTheIndexSum) {
  const CadFace face = kite(radians(30));
  CriticalPoints points = points_of(face);
  ASSERT_EQ(points.corners[0].valence, 0);
  const int sum = points.index_sum;
  divide_degenerate_corners(face, points);
  EXPECT_EQ(points.corners[0].valence, 1);
  EXPECT_EQ(points.corners[0].source, NodeSource::divide);
  ASSERT_EQ(points.critical_points.size(), 1u);
  const CriticalPoint& node = points.critical_points[0];
  EXPECT_EQ(node.valence, 3);
  EXPECT_NEAR(node.position.x, 1.25, 1e-5);  // a quarter of the way to the opposite corner
  EXPECT_NEAR(node.position.y, 0, 1e-12);
  EXPECT_EQ(index_sum_of(points), sum);
  EXPECT_EQ(points.form, NodeForm::phase);
  ASSERT_EQ(points.changes.size(), 1u);
  EXPECT_EQ(points.changes[0].kind, ChangeKind::divide);
}

TEST(DivideCorners, OtherCornersAndSharperOnesStay) {
  CriticalPoints points = points_of(square());
  divide_degenerate_corners(square(), points);
  EXPECT_TRUE(points.changes.empty());
  EXPECT_EQ(points.form, NodeForm::harmonic);
  const double h = 4 * std::tan(radians(5));
  const CadFace face = make_face({polygon({{0, 0}, {4, -h}, {4, h}})});
  CriticalPoints sharp = points_of(face);
  divide_degenerate_corners(face, sharp);
  EXPECT_EQ(sharp.corners[0].valence, 0);
  EXPECT_TRUE(sharp.critical_points.empty());
}

TEST(DivideCorners, AShortSideDrawsTheNodeNearer) {
  const CadFace face = make_face({polygon({{0, 0}, {0.4, 0}, {0.5, -0.4}, {4, -0.4}, {4, 4 * std::tan(radians(30))}})});
  CriticalPoints points = points_of(face);
  ASSERT_EQ(points.corners[0].valence, 0);
  divide_degenerate_corners(face, points);
  EXPECT_NEAR(norm(points.critical_points.at(0).position), 0.2, 1e-9);
}

}  // namespace
}  // namespace quadrille::guide
