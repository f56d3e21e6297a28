#include "topology/apply_topology.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/critical_points.hpp"
#include "far_field_faces.hpp"

namespace quadrille::topology {
namespace {

using namespace testing_faces;
using hand_made::node;

/// What is left of these nodes. `is_placed`: whether they have to be placed.
CriticalPoints applied(const CadFace& face, const TopologyOptions& options, const std::vector<CriticalPoint>& nodes,
                       bool is_placed) {
  CriticalPoints points = hand_made::points_of(face, nodes);
  points.index_sum_expected = 4 * face.euler_characteristic();
  EXPECT_EQ(points.index_sum, points.index_sum_expected);
  EXPECT_EQ(apply_topology(face, options, points), is_placed);
  EXPECT_EQ(index_sum_of(points), points.index_sum_expected);
  hand_made::expect_sound_changes(points.changes);
  return points;
}

const std::vector<CriticalPoint> pair{node({4, 0.5}, 3), node({-2, 0.5}, 5)};

TEST(ApplyTopology, KeepsTheNodesOfTheFieldWithoutAFarField) {
  EXPECT_EQ(applied(square(), {}, pair, false).critical_points.size(), 2U);
  EXPECT_TRUE(applied(square(), {NodeRule::fewest}, pair, true).critical_points.empty());
}

TEST(ApplyTopology, BetweenAWallAndItsOffsetCurveThereAreTheFewestNodes) {
  CadFace face = make_face({c_outline(), sharp_body()});
  const std::string wall = face.curve_names[face.num_curves() - 1];
  EXPECT_EQ(applied(face, {}, pair, false).critical_points.size(), 2U);
  face.curve_names[0] = wall + "_offset";
  EXPECT_TRUE(applied(face, {}, pair, true).critical_points.empty());
  EXPECT_EQ(applied(face, {NodeRule::field}, pair, false).critical_points.size(), 2U);
}

TEST(ApplyTopology, ACFarFieldNeedsNoNode) {
  const CadFace face = in_far_field(make_face({c_outline(), sharp_body()}));
  EXPECT_TRUE(applied(face, {}, pair, true).critical_points.empty());
  EXPECT_EQ(applied(face, {NodeRule::field}, pair, false).critical_points.size(), 2U);
  EXPECT_EQ(applied(face, {NodeRule::by_grid, GridKind::none}, pair, false).critical_points.size(), 2U);
}

TEST(ApplyTopology, ACircleHasANodeInTheWakeOfASharpTail) {
  const CadFace face = in_far_field(make_face({circle({0, 0}, 8), sharp_body()}));
  const CriticalPoints points = applied(face, {}, {node({-4, 0.5}, 3), node({-4, -0.5}, 3)}, false);
  ASSERT_EQ(points.critical_points.size(), 1U);
  EXPECT_EQ(points.critical_points[0].valence, 3);
  const double size = 1.2;  // from the tail to the foremost point of the round front, which is no joint
  EXPECT_NEAR(distance(points.critical_points[0].position, {1 + 2 * size, 0}), 0, 1e-12);
  EXPECT_EQ(points.corners.front().valence, 3);
}

TEST(ApplyTopology, ABoxKeepsItsNodesBeforeTheNose) {
  const CadFace face = in_far_field(make_face({box(), sharp_body()}));
  const std::vector<CriticalPoint> nodes{node({-1, 0.5}, 5), node({-1, -0.5}, 5)};
  EXPECT_EQ(applied(face, {}, nodes, true).critical_points.size(), 2U);
  // A C-grid in the box has two blocks in each upstream corner instead.
  EXPECT_TRUE(applied(face, {NodeRule::by_grid, GridKind::c}, nodes, true).critical_points.empty());
  EXPECT_TRUE(applied(face, {NodeRule::none}, nodes, true).critical_points.empty());
}

}  // namespace
}  // namespace quadrille::topology
