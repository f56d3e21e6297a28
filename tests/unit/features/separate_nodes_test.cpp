#include "features/separate_nodes.hpp"

#include <gtest/gtest.h>

#include "feature_faces.hpp"

namespace quadrille::features {
namespace {

using namespace testing_features;

FeatureState separated(const CadFace& face, double size, const std::vector<FeatureNode>& nodes) {
  FeatureState state = state_of(face, size, nodes);
  separate_nodes(state, curve::FaceBoundary(face));
  expect_sound_changes(state.changes);
  return state;
}

FeatureNode changed(FeatureNode node) {
  node.changed_by = ChangeKind::feature;
  return node;
}

bool has_no_room(const FeatureState& state) {
  return !state.changes.empty() && state.changes.back().reason.find("no room") != std::string::npos;
}

TEST(FeetOf, HasOneFootOnEachCurveInReach) {
  const CadFace face = plate(2);
  const curve::FaceBoundary boundary(face);
  EXPECT_TRUE(feet_of(boundary, {0, 0}, 2).empty());  // nearer than the reach, not as near
  EXPECT_EQ(feet_of(boundary, {0, 0}, 2.1).size(), 4u);
  EXPECT_EQ(feet_of(boundary, {1.8, 0}, 1).size(), 1u);
}

TEST(FeetOf, CountsACornerThatTwoCurvesShareOnce) {
  const CadFace face = plate(4, {window({-1, -1}, {1, 1}, 0)});
  const std::vector<CurveFoot> feet = feet_of(curve::FaceBoundary(face), {1.3, 1.4}, 1);
  ASSERT_EQ(feet.size(), 1u);
  EXPECT_NEAR(distance(feet[0].position, {1, 1}), 0, 1e-12);
  EXPECT_TRUE(feet[0].is_reflex);
}

TEST(FeetOf, KnowsWhereTheBoundaryTurnsAway) {
  const CadFace face = plate(4, {window({-1, -1}, {1, 1}, 0.2)});
  const curve::FaceBoundary boundary(face);
  const auto count_reflex = [&](Vec2 x) {
    const std::vector<CurveFoot> feet = feet_of(boundary, x, 0.25);
    return std::count_if(feet.begin(), feet.end(), [](const CurveFoot& foot) { return foot.is_reflex; });
  };
  EXPECT_EQ(count_reflex({1.1, 1.1}), 1);   // before a fillet
  EXPECT_EQ(count_reflex({1.2, 0.85}), 2);  // before its end: the fillet and the end of the straight side
  EXPECT_EQ(count_reflex({1.2, 0}), 0);     // before a straight side
  EXPECT_EQ(count_reflex({3.9, 3.9}), 0);   // in a convex corner
}

TEST(SeparateNodes, PushesInnerNodesApartBothAlike) {
  const FeatureState state = separated(plate(2), 0.4, {inner_node({-0.01, 0}, 5), inner_node({0.01, 0}, 5)});
  const Vec2 a = state.nodes[0].position, b = state.nodes[1].position;
  EXPECT_GE(distance(a, b), 0.2);
  EXPECT_LE(distance(a, b), 0.21);
  EXPECT_LE(norm(a + b), 1e-12);
  EXPECT_EQ(state.changes.size(), 2u);
}

TEST(SeparateNodes, LeavesNodesThatAreFarEnough) {
  const FeatureState state = separated(plate(2), 0.4, {inner_node({0, 0}, 5), inner_node({0.2, 0}, 5)});
  EXPECT_TRUE(state.changes.empty());
  EXPECT_FALSE(state.nodes[0].is_changed());
}

TEST(SeparateNodes, PushesAnInnerNodeOffABoundaryNodeThatStays) {
  const CadFace face = plate(2);
  const FeatureState state = separated(face, 0.4, {boundary_node(face, 0, 2), inner_node({0, -1.9}, 5)});
  EXPECT_EQ(state.nodes[0].position, (Vec2{0, -2}));
  EXPECT_NEAR(state.nodes[1].position.y, -1.8, 1e-3);
}

TEST(SeparateNodes, PushesChangedNodesOffTheBoundaryButNoOthers) {
  const FeatureNode node = inner_node({0, -1.95}, 5);
  EXPECT_TRUE(separated(plate(2), 0.4, {node}).changes.empty());
  const FeatureState state = separated(plate(2), 0.4, {changed(node)});
  EXPECT_GE(state.nodes[0].position.y, -1.8 - 1e-12);
}

TEST(SeparateNodes, LeavesChangedNodesBesideReflexBoundary) {
  const CadFace face = plate(2, {round_hole({0, 0}, 0.1)});
  EXPECT_TRUE(separated(face, 0.4, {changed(inner_node({0.15, 0}, 5))}).changes.empty());
}

TEST(SeparateNodes, PushesNoNodeOntoReflexBoundary) {
  const CadFace face = plate(2, {round_hole({0, 0}, 0.3)});
  const FeatureState state = separated(face, 3.6, {boundary_node(face, 0, 2), changed(inner_node({0, -1.2}, 5))});
  EXPECT_GT(curve::FaceBoundary(face).nearest(state.nodes[1].position).distance, 0.4);
}

TEST(SeparateNodes, RecordsPairsWithoutRoomButNotThoseOfOneHole) {
  const CadFace face = plate(2, {round_hole({0, 0}, 0.1)});
  const double t = face.curves[4].end();
  FeatureNode a = boundary_node(face, 4, 0.2 * t), b = boundary_node(face, 4, 0.3 * t);
  EXPECT_TRUE(has_no_room(separated(face, 1, {a, b})));
  a.hole = b.hole = 0;
  EXPECT_TRUE(separated(face, 1, {a, b}).changes.empty());
}

TEST(SeparateNodes, RecordsNodesThatStayNearTheBoundary) {
  const CadFace strip = hand_made::face({rectangle({0, 0}, {4, 0.2}, 0)}, 4.1);
  const FeatureState state = separated(strip, 1, {changed(inner_node({2, 0.1}, 5))});
  EXPECT_TRUE(has_no_room(state));
}

}  // namespace
}  // namespace quadrille::features
