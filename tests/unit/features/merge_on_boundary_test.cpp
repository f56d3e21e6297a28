#include "features/merge_on_boundary.hpp"

#include <gtest/gtest.h>

#include "feature_faces.hpp"

namespace quadrille::features {
namespace {

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
