#include "guide/absorb.hpp"

#include <gtest/gtest.h>

#include "../support/polygon_field.hpp"
#include "../support/square_field.hpp"
#include "guide/find_critical_points.hpp"

namespace quadrille::guide {
namespace {

/// Hand-made zeros beside the corner of 135 degrees at the lower left of a square: only places and indices count.
struct AbsorbTest : testing::Test {
  Field field = interpolated_field(square_mesh({0, 0}, 1, 1), 1, [](Vec2) { return Vec2{1, 0}; });
  field::FieldEvaluator evaluator{field};
  CriticalPoints points;
  std::vector<Corner>& corners = points.corners;
  std::vector<NodeChange>& changes = points.changes;

  AbsorbTest() { corners = {{0, {0, 0}, 135, 2, {3, 0}}, {1, {1, 0}, 90, 1, {0, 1}}}; }

  static zeros::FoundZero zero(Vec2 x, int index) {
    zeros::FoundZero result;
    result.x = x;
    result.index = index;
    return result;
  }
  std::vector<bool> absorb(const std::vector<zeros::FoundZero>& zeros, double length = 0.01) {
    return absorb_into_corners(field.mesh.face, zeros, length, points);
  }
};

TEST_F(AbsorbTest, a_node_within_the_length_goes_into_the_valence_and_is_told) {
  EXPECT_EQ(absorb({zero({0.006, 0.008}, 1)}), std::vector<bool>{true});  // exactly as far as the length
  EXPECT_EQ(corners[0].valence, 1);
  EXPECT_EQ(corners[0].source, NodeSource::absorb);
  ASSERT_EQ(changes.size(), 1u);
  const NodeChange& change = changes[0];
  EXPECT_EQ(change.kind, ChangeKind::absorb);
  ASSERT_EQ(change.before.size(), 2u);
  EXPECT_EQ(change.before[0].valence, 2);
  EXPECT_EQ(change.before[0].location, NodeLocation::corner);
  EXPECT_EQ(change.before[1].valence, 3);
  EXPECT_EQ(change.before[1].location, NodeLocation::inside);
  ASSERT_EQ(change.after.size(), 1u);
  EXPECT_EQ(change.after[0].valence, 1);
}

TEST_F(AbsorbTest, one_beyond_or_with_a_valence_that_is_not_admissible_stays) {
  EXPECT_EQ(absorb({zero({0.007, 0.008}, 1)}), std::vector<bool>{false});
  EXPECT_EQ(absorb({zero({0.001, 0.001}, -1)}), std::vector<bool>{false});  // would be 3 at 135 degrees
  EXPECT_EQ(absorb({zero({0.999, 0.001}, 1)}), std::vector<bool>{false});   // would be 0 at a right angle
  EXPECT_EQ(absorb({zero({0.001, 0.001}, 1)}, 0), std::vector<bool>{false});
  EXPECT_TRUE(changes.empty());
  EXPECT_EQ(corners[0].valence, 2);
}

TEST_F(AbsorbTest, nodes_as_near_go_together_or_not_at_all) {
  EXPECT_EQ(absorb({zero({0.001, 0.002}, 1), zero({0.002, 0.001}, 1)}), (std::vector<bool>{false, false}));
  EXPECT_EQ(absorb({zero({0.001, 0.002}, 1), zero({0.003, 0.001}, -1)}), (std::vector<bool>{true, true}));
  EXPECT_EQ(corners[0].valence, 2);
  EXPECT_EQ(changes.size(), 2u);
}

TEST_F(AbsorbTest, a_node_as_near_to_two_corners_goes_to_neither) {
  corners[1].angle_degrees = 135;
  corners[1].valence = 2;
  EXPECT_EQ(absorb({zero({0.5, 0.001}, 1)}, 0.6), std::vector<bool>{false});
  EXPECT_EQ(absorb({zero({0.499, 0.001}, 1)}, 0.6), std::vector<bool>{true});
  EXPECT_EQ(corners[0].valence, 1);
}

TEST(Absorb, the_length_alone_decides_beside_a_corner_near_a_tie) {
  const double excess = 1e-4;  // off 135 degrees
  const Field field =
      adapted_field(polygon_face({{0, 0}, {2, 0}, {2, 0.7}, {1.7, 0.7 + 0.3 * std::tan(pi / 4 + excess)}, {0, 1.4}}));
  const field::FieldEvaluator evaluator(field);
  Report report;
  const CriticalPoints free = find_critical_points(evaluator, {0, 0, 1e-10}, report);
  ASSERT_EQ(free.critical_points.size(), 1u);
  EXPECT_EQ(free.corners[2].valence, 2);
  EXPECT_EQ(free.corners[2].source, NodeSource::angle);
  EXPECT_TRUE(free.zeros.empty());
  const double share = distance(free.critical_points[0].position, {2, 0.7}) / field.mesh.face.diameter;
  for (const double length : {0.99 * share, 1.01 * share}) {
    const CriticalPoints points = find_critical_points(evaluator, {0, length, 1e-10}, report);
    const bool absorbed = length > share;
    EXPECT_EQ(points.corners[2].valence, absorbed ? 1 : 2);
    EXPECT_EQ(points.critical_points.size(), absorbed ? 0u : 1u);
    EXPECT_EQ(points.zeros.size(), absorbed ? 1u : 0u);
    EXPECT_EQ(points.changes.size(), absorbed ? 1u : 0u);
    EXPECT_EQ(points.index_sum, 4);
  }
}

}  // namespace
}  // namespace quadrille::guide
