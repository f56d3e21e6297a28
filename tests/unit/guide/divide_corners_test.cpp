#include "guide/divide_corners.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/critical_points.hpp"
#include "../triangulate/faces.hpp"
#include "base/angle.hpp"
#include "curve/face_boundary.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::guide {
namespace {

using namespace testing_faces;

// Its sharp corner at the origin, the bisector along x.
CadFace needle(const std::vector<Loop>& holes = {}) {
  std::vector<Loop> loops{polygon({{0, 0}, {4, -0.4}, {4, 0.4}})};
  loops.insert(loops.end(), holes.begin(), holes.end());
  return make_face(loops);
}

// Between two arcs of radius 1 that leave the origin at angles of +-0.05 radians and bend to the left.
CadFace hook() {
  const auto centre = [](double angle) { return Vec2{-std::sin(angle), std::cos(angle)}; };
  const Nurbs lower = curve::circular_arc(centre(-0.05), 1, -half_pi - 0.05, -half_pi + 0.75);
  const Nurbs upper = curve::circular_arc(centre(0.05), 1, -half_pi + 0.75, -half_pi + 0.05);
  return make_face({{lower, curve::segment(lower.poles.back(), upper.poles.front()), upper}});
}

TEST(MiddleLine, IsTheBisectorOfStraightSides) {
  const CadFace face = needle();
  const MiddleLine line = middle_line(face, 0);
  EXPECT_NEAR(line.side, std::hypot(4, 0.4), 1e-14);
  EXPECT_NEAR(length_inside(face, line), 4, 1e-9);
  EXPECT_LE(distance(point_at(line, 1.5), {1.5, 0}), 1e-14);
  EXPECT_EQ(length_of_small_turn(line, 1), INFINITY);
}

TEST(MiddleLine, EndsAtAHole) {
  const CadFace face = needle({hole({3, 0}, 0.05)});
  EXPECT_NEAR(length_inside(face, middle_line(face, 0)), 2.95, 1e-9);
}

TEST(MiddleLine, FollowsSidesThatBend) {
  const CadFace face = hook();
  const MiddleLine line = middle_line(face, 0);
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    // The middle line is an arc of radius 1 that leaves the origin along x.
    EXPECT_NEAR(distance(line.points[i], {0, 1}), 1, 2e-3);
    EXPECT_NEAR(line.widths[i], 0.1 * norm(line.points[i]), 2e-3);
  }
  EXPECT_NEAR(length_inside(face, line), 0.7, 0.05);
}

TEST(MiddleLine, ABentWedgeHasLittleOfSmallTurn) {
  // An arc of radius 1 turns by its length; the corner sees the width under 0.1 radians.
  EXPECT_NEAR(length_of_small_turn(middle_line(hook(), 0), 1), 0.1, 0.02);
  EXPECT_NEAR(length_of_small_turn(middle_line(hook(), 0), 3), 0.3, 0.03);
}

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

TEST(DivideCorners, OtherCornersStay) {
  CriticalPoints points = points_of(square());
  divide_degenerate_corners(square(), points);
  EXPECT_TRUE(points.changes.empty());
  EXPECT_EQ(points.form, NodeForm::harmonic);
}

TEST(DivideCorners, AnyAngleAboveZeroGetsABlock) {
  for (const double angle : {14.0, 5.0, 1.0, 0.1}) {
    const CadFace face = kite(radians(angle));
    CriticalPoints points = points_of(face);
    const int sum = points.index_sum;
    divide_degenerate_corners(face, points);
    EXPECT_EQ(points.corners[0].valence, 1);
    EXPECT_NEAR(points.critical_points.at(0).position.x, 1.25, 1e-5);
    EXPECT_EQ(index_sum_of(points), sum);
  }
}

// Between two arcs from (0, 0) to (1, 0) below, with this angle between them at both ends.
CadFace crescent(double angle) {
  const auto arc = [](double half, bool is_forward) {
    const Vec2 centre{0.5, 0.5 / std::tan(half)};
    const double radius = 0.5 / std::sin(half);
    return is_forward ? curve::circular_arc(centre, radius, -half_pi - half, -half_pi + half)
                      : curve::circular_arc(centre, radius, -half_pi + half, -half_pi - half);
  };
  return make_face({{arc(1, true), arc(1 - angle, false)}});
}

TEST(DivideCorners, TheNodeOfABentWedgeIsInItsMiddle) {
  for (const double angle : {0.2, 0.05, 0.01}) {
    const CadFace face = crescent(angle);
    CriticalPoints points = points_of(face);
    divide_degenerate_corners(face, points);
    ASSERT_EQ(points.critical_points.size(), 2u);
    const Vec2 a = points.critical_points[0].position, b = points.critical_points[1].position;
    EXPECT_NEAR(a.x, 1 - b.x, 1e-9);
    EXPECT_NEAR(a.y, b.y, 1e-9);
    // The wedge turns by no more than its angle up to there.
    EXPECT_LE(std::min(norm(a), norm(b)), angle);
    EXPECT_GE(std::min(norm(a), norm(b)), angle / 8);
    EXPECT_NEAR(curve::FaceBoundary(face).signed_distance(a), angle * std::min(norm(a), norm(b)) / 2,
                0.4 * angle * norm(b));
  }
}

TEST(DivideCorners, SharpCornersAreReportedWithTheirFigure) {
  const CadFace face = kite(radians(6));
  CriticalPoints points = points_of(face);
  Report before, after;
  report_sharp_corners(face, points, before);  // no block, no limit
  EXPECT_TRUE(before.warnings().empty());
  divide_degenerate_corners(face, points);
  report_sharp_corners(face, points, after);
  ASSERT_EQ(after.warnings().size(), 1u);
  EXPECT_EQ(after.warnings()[0].code, "W-NODE-003");
  EXPECT_EQ(after.warnings()[0].message,
            "one corner is below 15 degrees: that of 6 degrees at (0, 0) limits the scaled Jacobian to 0.1");
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
