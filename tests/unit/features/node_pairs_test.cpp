#include "features/node_pairs.hpp"

#include <gtest/gtest.h>

#include "feature_faces.hpp"

namespace quadrille::features {
namespace {

using namespace testing_features;

FeatureState cancelled(const CadFace& face, const std::vector<FeatureNode>& nodes, double below) {
  FeatureState state = state_of(face, 2 * below, nodes);
  cancel_pairs(state, curve::FaceBoundary(face), below);
  expect_sound_changes(state.changes);
  return state;
}

TEST(CancelPairs, RemovesTwoOfOppositeIndexThatAreNearerThanTheLength) {
  const std::vector<FeatureNode> pair{inner_node({0, 0}, 3), inner_node({0.1, 0}, 5)};
  EXPECT_TRUE(cancelled(plate(2), pair, 0.11).nodes.empty());
  EXPECT_EQ(cancelled(plate(2), pair, 0.1).nodes.size(), 2u);  // not nearer
}

TEST(CancelPairs, LeavesNodesOfOneSign) {
  const FeatureState state = cancelled(plate(2), {inner_node({0, 0}, 5), inner_node({0.1, 0}, 5)}, 0.5);
  EXPECT_EQ(state.nodes.size(), 2u);
  EXPECT_TRUE(state.changes.empty());
}

TEST(CancelPairs, TakesTheNearestPairFirst) {
  const FeatureState state =
      cancelled(plate(2), {inner_node({0, 0}, 3), inner_node({0.1, 0}, 5), inner_node({0.25, 0}, 3)}, 0.5);
  ASSERT_EQ(state.nodes.size(), 1u);
  EXPECT_EQ(state.nodes[0].position, (Vec2{0.25, 0}));
  EXPECT_FALSE(state.nodes[0].is_changed());
}

TEST(CancelPairs, PutsOneInTheMiddleOfPairsThatAreEquallyNear) {
  const FeatureState state =
      cancelled(plate(2), {inner_node({-0.1, 0}, 5), inner_node({0, 0}, 3), inner_node({0.1, 0}, 5)}, 0.2);
  ASSERT_EQ(state.nodes.size(), 1u);
  EXPECT_EQ(state.nodes[0].valence, 5);
  EXPECT_NEAR(norm(state.nodes[0].position), 0, 1e-15);
  EXPECT_EQ(state.nodes[0].changed_by, ChangeKind::cancel);
}

TEST(CancelPairs, LeavesSetsThatNoOneNodeCanReplaceAndGoesOnWithTheNextClass) {
  std::vector<FeatureNode> star{inner_node({0, 0}, 3)};
  for (int k = 0; k < 4; ++k) star.push_back(inner_node(0.3 * unit(k * half_pi), 5));
  EXPECT_EQ(cancelled(plate(2), star, 0.4).nodes.size(), 5u);
  star.push_back(inner_node({1, 1}, 3));
  star.push_back(inner_node({1, 1.35}, 5));  // farther apart than the star's pairs
  EXPECT_EQ(cancelled(plate(2), star, 0.4).nodes.size(), 5u);
}

TEST(CancelPairs, TakesABoundaryNodeWithAnInnerOneButNotTwoOfThem) {
  const CadFace face = plate(2);
  const FeatureNode on_boundary = boundary_node(face, 0, 2);  // (0, -2), index -1
  EXPECT_TRUE(cancelled(face, {on_boundary, inner_node({0, -1.9}, 3)}, 0.2).nodes.empty());
  const FeatureState both = cancelled(face, {on_boundary, boundary_node(face, 0, 2.1, 1)}, 0.2);
  EXPECT_EQ(both.nodes.size(), 2u);
}

TEST(CancelPairs, KeepsABoundaryNodeThatNothingBalances) {
  // Index -1, +1, -1 at equal distances: a middle would have to leave the boundary.
  const CadFace face = plate(2);
  const FeatureState state =
      cancelled(face, {boundary_node(face, 0, 1.9), inner_node({0, -1.95}, 3), boundary_node(face, 0, 2.1)}, 0.2);
  EXPECT_EQ(state.nodes.size(), 3u);
}

TEST(CancelPairs, LeavesNodesOfFilletsThatAreCornersAtTheirDistance) {
  const CadFace face = plate(2);
  const auto left = [&](double depth, double other_depth) {
    return cancelled(face, {inner_node({0, depth - 2}, 3), inner_node({2 - other_depth, -1}, 5)}, 3).nodes.size();
  };
  EXPECT_EQ(left(0.01, 0.01), 2u);
  EXPECT_EQ(left(0.2, 0.2), 0u);
  EXPECT_EQ(left(0.01, 0.2), 2u);
  EXPECT_EQ(left(0.2, 0.01), 2u);
  const CadFace window_face = plate(2, {window({-0.5, -0.5}, {0.5, 0.5}, 0.01)});
  const FeatureNode on_fillet = boundary_node(window_face, 4, window_face.curves[4].end() / 2);
  EXPECT_EQ(cancelled(window_face, {on_fillet, inner_node({-1, -1}, 3)}, 1).nodes.size(), 2u);
  EXPECT_EQ(cancelled(window_face, {on_fillet, inner_node({-0.55, -0.55}, 3)}, 1).nodes.size(), 0u);
}

TEST(CancelPairs, DoesNotReachThroughTheBoundary) {
  const CadFace face = plate(2, {round_hole({0, 0}, 0.1)});
  EXPECT_EQ(cancelled(face, {inner_node({0, 0.2}, 5), inner_node({0, -0.2}, 3)}, 0.45).nodes.size(), 2u);
}

using namespace testing_features;

/// Curve 0 runs from (-2, -2) to (2, -2), its parameter is the length.
FeatureState merged(const CadFace& face, double size, const std::vector<FeatureNode>& nodes) {
  FeatureState state = state_of(face, size, nodes);
  merge_on_boundary(face, state);
  expect_sound_changes(state.changes);
  return state;
}

TEST(MergeOnBoundary, PutsOneOfValence4InTheMiddle) {
  const CadFace face = plate(2);
  const FeatureState state = merged(face, 0.5, {boundary_node(face, 0, 1), boundary_node(face, 0, 1.2)});
  ASSERT_EQ(state.nodes.size(), 1u);
  EXPECT_EQ(state.nodes[0].valence, 4);
  EXPECT_EQ(state.nodes[0].location, NodeLocation::boundary);
  EXPECT_NEAR(state.nodes[0].t, 1.1, 1e-12);
  EXPECT_EQ(state.nodes[0].changed_by, ChangeKind::feature);
}

TEST(MergeOnBoundary, NeedsHalfTheSizeAndValence3) {
  const CadFace face = plate(2);
  EXPECT_EQ(merged(face, 0.4, {boundary_node(face, 0, 1), boundary_node(face, 0, 1.2)}).nodes.size(), 2u);
  EXPECT_EQ(merged(face, 0.5, {boundary_node(face, 0, 1, 4), boundary_node(face, 0, 1.2)}).nodes.size(), 2u);
  EXPECT_EQ(merged(face, 0.5, {inner_node({-1, -1.9}, 5), boundary_node(face, 0, 1)}).nodes.size(), 2u);
}

TEST(MergeOnBoundary, DoesNotGoRoundACornerOrAcross) {
  const CadFace face = plate(2);
  EXPECT_EQ(merged(face, 1, {boundary_node(face, 0, 3.9), boundary_node(face, 1, 0.1)}).nodes.size(), 2u);
  // Opposite sides of a thin strip: near, but far along the boundary.
  const CadFace strip = hand_made::face({rectangle({0, 0}, {4, 0.2}, 0.05)}, 4.1);
  EXPECT_EQ(merged(strip, 1, {boundary_node(strip, 1, 2), boundary_node(strip, 5, 2)}).nodes.size(), 2u);
}

TEST(MergeOnBoundary, LeavesNodesOnFilletsThatAreCornersAtTheirDistance) {
  for (const double radius : {0.01, 0.1}) {
    const CadFace face = plate(2, {window({-0.5, -0.25}, {0.5, 0.25}, radius)});
    const auto on_arc = [&](int curve) { return boundary_node(face, curve, face.curves[curve].end() / 2); };
    // Of the hole: arcs 4, 6, 8, 10; those at the ends of the first short side are half a unit apart.
    EXPECT_EQ(merged(face, 1.2, {on_arc(4), on_arc(6)}).nodes.size(), radius == 0.01 ? 2u : 1u) << radius;
  }
}

TEST(MergeOnBoundary, LeavesTheNodesOfOneHole) {
  const CadFace face = plate(2, {round_hole({0, 0}, 0.1)});
  const double t = face.curves[4].end();
  FeatureNode a = boundary_node(face, 4, 0.2 * t), b = boundary_node(face, 4, 0.3 * t);
  EXPECT_EQ(merged(face, 1, {a, b}).nodes.size(), 1u);
  a.hole = b.hole = 0;
  EXPECT_EQ(merged(face, 1, {a, b}).nodes.size(), 2u);
}

TEST(MergeOnBoundary, TakesNearerPairsFirstAndTiesThatShareANodeNotAtAll) {
  const CadFace face = plate(2);
  const FeatureState nearest =
      merged(face, 1, {boundary_node(face, 0, 1), boundary_node(face, 0, 1.2), boundary_node(face, 0, 1.5)});
  ASSERT_EQ(nearest.nodes.size(), 2u);
  EXPECT_NEAR(nearest.nodes[0].t, 1.1, 1e-12);
  EXPECT_EQ(nearest.nodes[1].t, 1.5);
  const FeatureState tied =
      merged(face, 0.7, {boundary_node(face, 0, 1), boundary_node(face, 0, 1.25), boundary_node(face, 0, 1.5)});
  EXPECT_EQ(tied.nodes.size(), 3u);
}

}  // namespace
}  // namespace quadrille::features
