#include "topology/fewest_nodes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/critical_points.hpp"
#include "../triangulate/faces.hpp"

namespace quadrille::topology {
namespace {

using namespace testing_faces;
using hand_made::node;
using hand_made::points_of;

/// The points with the fewest nodes; each change must be sound.
CriticalPoints fewest(const CadFace& face, const std::vector<CriticalPoint>& nodes, int max_valence = 6) {
  CriticalPoints points = points_of(face, nodes);
  keep_fewest_nodes(face, max_valence, points);
  EXPECT_EQ(points.index_sum, points.index_sum_expected);
  hand_made::expect_sound_changes(points.changes);
  return points;
}

TEST(FewestNodes, OfOneSignStay) {
  CriticalPoints points = points_of(square(), {node({0.3, 0.5}, 3), node({0.7, 0.5}, 3)});
  EXPECT_FALSE(keep_fewest_nodes(square(), 6, points));
  EXPECT_EQ(points.form, NodeForm::harmonic);
  EXPECT_TRUE(points.changes.empty());
}

TEST(FewestNodes, APairIsRemoved) {
  const CriticalPoints points = fewest(square(), {node({0.2, 0.3}, 3), node({0.7, 0.6}, 5)});
  EXPECT_TRUE(points.critical_points.empty());
  EXPECT_EQ(points.form, NodeForm::phase);
  EXPECT_EQ(points.zeros.size(), 2U);
  ASSERT_EQ(points.changes.size(), 1U);
  EXPECT_EQ(points.changes[0].kind, ChangeKind::cancel);
}

TEST(FewestNodes, TheNearestPairIsRemovedFirst) {
  const CriticalPoints points = fewest(square(), {node({0.1, 0.5}, 3), node({0.5, 0.5}, 5), node({0.7, 0.5}, 3)});
  ASSERT_EQ(points.critical_points.size(), 1U);
  EXPECT_EQ(points.critical_points[0].position.x, 0.1);
}

TEST(FewestNodes, PairsThatShareANodeBecomeOneOnTheAxis) {
  const CriticalPoints points = fewest(square(), {node({0.3, 0.6}, 3), node({0.5, 0.4}, 5), node({0.7, 0.6}, 3)});
  ASSERT_EQ(points.critical_points.size(), 1U);
  EXPECT_EQ(points.critical_points[0].valence, 3);
  EXPECT_NEAR(points.critical_points[0].position.x, 0.5, 1e-14);  // on the mirror axis of the square
}

TEST(FewestNodes, ANodeOfGreaterValenceIsMergedToo) {
  const CriticalPoints points = fewest(square(), {node({0.4, 0.6}, 3), node({0.5, 0.5}, 6), node({0.6, 0.6}, 3)});
  EXPECT_TRUE(points.critical_points.empty());
}

TEST(FewestNodes, AGreaterIndexBecomesARing) {
  // Three nodes of valence 3 about one of valence 5: index 2, for which there is no single node.
  const double height = std::sqrt(0.75) * 0.2;
  const CriticalPoints points = fewest(
      square(), {node({0.5, 0.7}, 3), node({0.5 - height, 0.4}, 3), node({0.5, 0.5}, 5), node({0.5 + height, 0.4}, 3)});
  ASSERT_EQ(points.critical_points.size(), 2U);
  for (const CriticalPoint& p : points.critical_points) EXPECT_EQ(p.valence, 3);
}

TEST(FewestNodes, NodesOfDividedCornersStay) {
  CriticalPoint divided = node({0.4, 0.5}, 3);
  divided.source = NodeSource::divide;
  EXPECT_EQ(fewest(square(), {divided, node({0.6, 0.5}, 5)}).critical_points.size(), 2U);
}

TEST(FewestNodes, ImagesOfOnePairAreTreatedAlike) {
  const CriticalPoints points = fewest(square(), {node({0.1, 0.3}, 3), node({0.2, 0.3}, 5), node({0.8, 0.3}, 5),
                                                  node({0.9, 0.3}, 3), node({0.5, 0.8}, 3)});
  EXPECT_EQ(points.changes.size(), 2U);
  ASSERT_EQ(points.critical_points.size(), 1U);
  EXPECT_EQ(points.critical_points[0].position.y, 0.8);
}

}  // namespace
}  // namespace quadrille::topology
