#include "guide/valence.hpp"

#include <gtest/gtest.h>

#include <complex>

#include "../hand_made.hpp"
#include "../support/square_field.hpp"
#include "base/error.hpp"

namespace quadrille::guide {
namespace {

TEST(TieMeasures, TheAngleDefectIsZeroForBlocksOfRightAngles) {
  for (int valence = 1; valence <= 4; ++valence) EXPECT_NEAR(angle_defect(valence * half_pi, valence), 0, 1e-15);
  EXPECT_NEAR(angle_defect(radians(135), 1), 0.25, 1e-15);
  EXPECT_NEAR(angle_defect(radians(135), 2), 0.125, 1e-15) << "the larger valence is the better one at a tie";
}

TEST(TieMeasures, ASideIsMeasuredBetweenItsEnds) {
  const CadFace face = hand_made::quarter_annulus(1, 2).face;
  EXPECT_NEAR(side_length(face, 0), 1, 1e-15);
  EXPECT_NEAR(side_length(face, 1), 2 * std::sqrt(2.0), 1e-14) << "the chord of the arc";
  EXPECT_NEAR(side_length(face, 3), std::sqrt(2.0), 1e-14) << "the last curve ends where the first one starts";
}

TEST(TieDistance, is_zero_at_odd_multiples_of_45_degrees) {
  for (const double tie : {45.0, 135.0, 225.0, 315.0}) {
    EXPECT_NEAR(tie_distance(radians(tie)), 0, 1e-14);
    EXPECT_NEAR(tie_distance(radians(tie + 7)), radians(7), 1e-14);
    EXPECT_NEAR(tie_distance(radians(tie - 7)), radians(7), 1e-14);
  }
  EXPECT_NEAR(tie_distance(half_pi), pi / 4, 1e-14);
}

/// One triangle with 45 degrees at 0 between the x axis (outgoing) and the diagonal (incoming), and the field that
/// goes on the chord from (1, 0) to (-1, 0), moved sideways by c r^4 sin 4 theta.
Field wedge_field(double c) {
  const std::array<Vec2, 3> p{Vec2{0, 0}, Vec2{1, 0}, Vec2{0.6, 0.6}};
  TriMesh mesh;
  mesh.face.diameter = 1;
  mesh.face.loop_offsets = {0, 3};
  mesh.vertices = {p[0], p[1], p[2]};
  mesh.elem2vertices = {{0, 1, 2}};
  for (int i = 0; i < 3; ++i) {
    const Vec2 before = p[(i + 2) % 3], after = p[(i + 1) % 3];
    mesh.face.curves.push_back(curve::segment(p[i], after));
    mesh.boundary_edges.push_back({0, i, i, 0, distance(p[i], after)});
    const double out = angle_of(after - p[i]), angle = wrap_two_pi(angle_of(before - p[i]) - out);
    mesh.face.joints.push_back({p[i], angle_of(p[i] - before), out, angle, true});
  }
  const Vec2 pole = -3 * unit(pi / 8);
  const double slope = -8 / pi;  // of u by the polar angle
  Field field = interpolated_field(mesh, 14, [&](Vec2 x) {
    const double side = c * std::pow(std::complex(x.x, x.y), 4).imag();
    return Vec2{1 + slope * angle_of(x - pole), side};
  });
  field.liftings = {{0, {0, 0}, pole, {slope, 0}}};
  return field;
}

TEST(CornerValences, a_tie_is_decided_by_the_next_term) {
  for (const double c : {3.0, 0.5}) {
    const Field smaller = wedge_field(c), larger = wedge_field(-c);
    EXPECT_EQ(corner_valences(field::FieldEvaluator(smaller)).corners[0].valence, 0);
    EXPECT_EQ(corner_valences(field::FieldEvaluator(larger)).corners[0].valence, 1);
  }
}

TEST(CornerValences, away_from_ties_is_the_nearest_integer) {
  const Field field = wedge_field(1);
  const std::vector<Corner> corners = corner_valences(field::FieldEvaluator(field)).corners;
  ASSERT_EQ(corners.size(), 3u);
  EXPECT_NEAR(corners[1].angle_degrees, degrees(std::atan2(0.6, 0.4)), 1e-12);
  EXPECT_EQ(corners[1].valence, 1);  // 56.3 degrees
  EXPECT_EQ(corners[2].valence, 1);  // 78.7 degrees
}

TEST(CornerValences, a_tie_that_the_field_leaves_open_is_an_error) {
  const Field field = wedge_field(0);
  EXPECT_THROW(corner_valences(field::FieldEvaluator(field)), ComputeError);
}

TEST(AdmissibleValence, blocks_have_15_to_165_degrees_but_those_of_sharp_corners) {
  EXPECT_TRUE(is_admissible_valence(90, 1));
  EXPECT_TRUE(is_admissible_valence(165, 1));
  EXPECT_FALSE(is_admissible_valence(166, 1));
  EXPECT_TRUE(is_admissible_valence(30, 2));
  EXPECT_FALSE(is_admissible_valence(29, 2));
  EXPECT_TRUE(is_admissible_valence(10, 0));
  EXPECT_FALSE(is_admissible_valence(10, 2));
  EXPECT_TRUE(is_admissible_valence(10, 1));  // a sharp corner needs a block
  EXPECT_FALSE(is_admissible_valence(90, -1));
  EXPECT_FALSE(is_admissible_valence(340, 5));
}

TEST(AdmissibleAfterAbsorption, keeps_blocks_between_15_and_165_degrees_and_near_right_angles) {
  EXPECT_TRUE(is_admissible_after_absorption(134, 1));
  EXPECT_TRUE(is_admissible_after_absorption(134, 2));
  EXPECT_FALSE(is_admissible_after_absorption(134, 3));
  EXPECT_TRUE(is_admissible_after_absorption(120, 2));   // 4/3 to 2: two thirds off
  EXPECT_FALSE(is_admissible_after_absorption(100, 2));  // 10/9 to 2
  EXPECT_FALSE(is_admissible_after_absorption(170, 1));
  EXPECT_TRUE(is_admissible_after_absorption(228.7, 2));
  EXPECT_TRUE(is_admissible_after_absorption(228.7, 3));
  EXPECT_FALSE(is_admissible_after_absorption(350, 5));
  EXPECT_FALSE(is_admissible_after_absorption(60, -1));
}

TEST(AdmissibleAfterAbsorption, zero_only_at_the_tie) {
  EXPECT_TRUE(is_admissible_after_absorption(45.5, 0));
  EXPECT_FALSE(is_admissible_after_absorption(60, 0));
}

/// One node of valence 3, one corner of valence 1, a boundary node of valence 3 and a cluster of index -2.
CriticalPoints some_points() {
  CriticalPoints points;
  points.critical_points.resize(1);
  points.critical_points[0].valence = 3;
  points.corners = {{0, {0, 0}, 90, 1, {1, 0}}};
  points.boundary_nodes.resize(1);
  points.clusters = {{{1, 1}, 0, -2, {{1, 1}}, {}}};
  return points;
}

TEST(IndexSumWithClusters, AddsNodesCornersBoundaryNodesAndClusters) {
  EXPECT_EQ(index_sum_with_clusters(some_points()), 1 + 1 - 1 - 2);
  EXPECT_EQ(index_sum_of(some_points()), 1 + 1 - 1);
}

TEST(RequireIndexSum, AcceptsTheExpectedSum) {
  CriticalPoints points = some_points();
  points.index_sum = points.index_sum_expected = 1;
  EXPECT_NO_THROW(require_index_sum(points, CadFace()));
  points.index_sum_expected = 2;
  EXPECT_THROW(require_index_sum(points, CadFace()), ComputeError) << "any other one is refused";
}

TEST(RequireIndexSum, ReportsTheDifferenceAndTheCornerNearestToATie) {
  CriticalPoints points;
  CadFace face;
  face.origin = {100, 0};
  points.corners = {{0, {0, 0}, 90, 1, {1, 0}}, {1, {1, 2}, 134, 1, {0, 1}}};
  points.index_sum = 2;
  points.index_sum_expected = 4;
  try {
    require_index_sum(points, face);
    FAIL();
  } catch (const ComputeError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("2 too few"), std::string::npos) << message;
    EXPECT_NE(message.find("134 degrees at (101, 2), valence 1"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace quadrille::guide
