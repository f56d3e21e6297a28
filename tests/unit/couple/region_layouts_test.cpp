#include "couple/region_layouts.hpp"

#include <gtest/gtest.h>

#include "../regions/faces_of_regions.hpp"

namespace quadrille::couple {
namespace {

using namespace testing_faces;

CadFace two_squares() { return face_of_regions({rectangle({0, 0}, {1, 1}), rectangle({1, 0}, {2, 1})}); }

CadFace four_squares() {
  return face_of_regions(
      {rectangle({0, 0}, {1, 1}), rectangle({1, 0}, {2, 1}), rectangle({0, 1}, {1, 2}), rectangle({1, 1}, {2, 2})});
}

// The middle of the region's part of a small circle about the point: where its sector is.
Vec2 into_sector(const CadFace& face, const BoundaryPoint& point) {
  const Vec2 out = curve::tangent(face.curves[point.curve], point.t);
  return point.is_joint(face) ? out + left_of(out) : left_of(out);
}

TEST(BoundaryPoint, TheEndOfACurveIsTheStartOfTheNextOne) {
  const CadFace face = square();
  EXPECT_EQ(boundary_point(face, 3, 1), (BoundaryPoint{0, 0}));
  EXPECT_EQ(boundary_point(face, 1, 0.5), (BoundaryPoint{1, 0.5}));
  EXPECT_TRUE(boundary_point(face, 0, 1).is_joint(face));
}

TEST(BoundaryPoint, NearAJointIsTheJoint) {
  const CadFace face = square();
  EXPECT_EQ(nearest_boundary_point(face, 0, {1 + 1e-10, 0}), (BoundaryPoint{1, 0}));
  const BoundaryPoint inside = nearest_boundary_point(face, 0, {1.1, 0.25});
  EXPECT_EQ(inside.curve, 1);
  EXPECT_NEAR(inside.t, 0.25, 1e-12);
}

TEST(BoundaryPoint, APointOfAnInterfaceIsOnBothCurves) {
  const CadFace face = two_squares();
  const std::vector<BoundaryPoint> points = coincident_points(face, {7, 0.75});
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0], (BoundaryPoint{1, 0.25})) << "the lower one first";
  EXPECT_EQ(points[1], (BoundaryPoint{7, 0.75}));
  EXPECT_TRUE(is_inside_whole(face, points[0]));
  EXPECT_EQ(coincident_points(face, {0, 0.5}), (std::vector<BoundaryPoint>{{0, 0.5}}));
  EXPECT_FALSE(is_inside_whole(face, {0, 0.5}));
}

TEST(BoundaryPoint, OppositeCurvesRunInOppositeDirections) {
  const CadFace face = two_squares();
  EXPECT_EQ(opposite_point(face, {1, 0}, 7), (BoundaryPoint{4, 0})) << "the start is the end of the other curve";
  EXPECT_EQ(opposite_point(face, {1, 0.25}, 7), (BoundaryPoint{7, 0.75}));
}

TEST(BoundaryPoint, AJunctionInsideHasASectorOfEachRegionCounterClockwise) {
  const CadFace face = four_squares();
  for (int c = 0; c < face.num_curves(); ++c) {
    if (distance(face.joints[c].position, {1, 1}) > 1e-12) continue;
    const std::vector<BoundaryPoint> points = coincident_points(face, {c, 0});
    ASSERT_EQ(points.size(), 4U);
    EXPECT_EQ(points.front().curve, 2) << "the lowest";
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(distance(left_of(into_sector(face, points[i])), into_sector(face, points[(i + 1) % 4])), 0, 1e-12);
    EXPECT_TRUE(is_inside_whole(face, points.front()));
  }
}

TEST(BoundaryPoint, OnTheBoundaryOfTheWholeTheFirstSectorBeginsAtTheBoundary) {
  const CadFace face = two_squares();
  for (const BoundaryPoint joint : {BoundaryPoint{1, 0}, BoundaryPoint{4, 0}}) {
    const std::vector<BoundaryPoint> points = coincident_points(face, joint);
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points[0], (BoundaryPoint{4, 0})) << "its outgoing curve is the bottom";
    EXPECT_EQ(points[1], (BoundaryPoint{1, 0}));
    EXPECT_FALSE(is_inside_whole(face, joint));
  }
}

}  // namespace
}  // namespace quadrille::couple
