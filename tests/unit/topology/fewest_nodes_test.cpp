#include "topology/fewest_nodes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "../support/critical_points.hpp"
#include "../triangulate/faces.hpp"

namespace quadrille::topology {
namespace {

using namespace testing_faces;
using hand_made::points_of;

/// The corners of the face with the index sum that it requires, whatever their valences.
CriticalPoints corners_of(const CadFace& face) {
  CriticalPoints points = points_of(face);
  points.index_sum_expected = 4 * face.euler_characteristic();
  return points;
}

std::vector<int> new_valences(const CadFace& face, const CriticalPoints& points) {
  std::vector<int> valences;
  for (const guide::CornerOverride& o : corners_without_nodes(face, points)) valences.push_back(o.valence);
  return valences;
}

TEST(CornersWithoutNodes, WhereTheSumHoldsNothingChanges) {
  for (const CadFace& face : {square(), l_shape(), annulus()})
    EXPECT_TRUE(new_valences(face, corners_of(face)).empty());
}

TEST(CornersWithoutNodes, ASquareAroundAHoleHasFourDiagonals) {
  const CadFace face = make_face({polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), hole({2, 2}, 1)});
  EXPECT_EQ(new_valences(face, corners_of(face)), (std::vector<int>{2, 2, 2, 2}));
}

TEST(CornersWithoutNodes, SymmetricCornersChangeTogether) {
  // A regular hexagon needs two corners of valence 2, but all six are images of each other.
  std::vector<Vec2> points;
  for (int k = 0; k < 6; ++k) points.push_back(unit(k * pi / 3));
  const CadFace hexagon = make_face({polygon(points)});
  EXPECT_TRUE(new_valences(hexagon, corners_of(hexagon)).empty());
  // Stretched, the four corners that are images of each other are too many, the two others are enough.
  for (Vec2& x : points) x.x *= 1.5;
  const CadFace stretched = make_face({polygon(points)});
  const std::vector<guide::CornerOverride> chosen = corners_without_nodes(stretched, corners_of(stretched));
  ASSERT_EQ(chosen.size(), 2U);
  for (const guide::CornerOverride& o : chosen) {
    EXPECT_EQ(o.valence, 2);
    EXPECT_EQ(o.curve_b % 3, 0);  // at (1.5, 0) and (-1.5, 0)
  }
}

TEST(CornersWithoutNodes, PrescribedValencesStay) {
  const CadFace face = make_face({polygon({{0, 0}, {4, 0}, {4, 3}, {0, 3}}), hole({2, 1.5}, 1)});
  CriticalPoints points = corners_of(face);
  for (Corner& c : points.corners) c.source = NodeSource::corner;
  EXPECT_TRUE(new_valences(face, points).empty());
}

TEST(CornersWithoutNodes, AsFewNodesAsPossibleIfSomeAreRequired) {
  // Two holes require index -8 with right angles of valence 1, and -4 with valence 2; valence 3 has too thin blocks.
  const CadFace face = make_face({polygon({{0, 0}, {8, 0}, {8, 4}, {0, 4}}), hole({2, 2}, 1), hole({6, 2}, 1)});
  EXPECT_EQ(new_valences(face, corners_of(face)), (std::vector<int>{2, 2, 2, 2}));
}

TEST(CornersWithoutNodes, BoundaryNodesAndNodesOfDividedCornersCount) {
  const CadFace face = make_face({polygon({{0, 0}, {4, 0}, {4, 3}, {0, 3}}), hole({2, 1.5}, 1)});
  CriticalPoints points = corners_of(face);
  points.boundary_nodes.assign(4, {});  // four of valence 3: index -4
  EXPECT_TRUE(new_valences(face, points).empty());
  points.boundary_nodes.clear();
  points.critical_points.assign(4, hand_made::node({1, 1}, 5));
  for (CriticalPoint& p : points.critical_points) p.source = NodeSource::divide;
  EXPECT_TRUE(new_valences(face, points).empty());
}

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

TEST(SpareNodes, AreThoseOfBothSignsInOneRegion) {
  CriticalPoints points;
  for (const auto& [index, elem] : {std::pair(1, 0), {1, 5}, {-1, 7}}) {
    EXPECT_FALSE(has_opposite_nodes(points, {}));
    points.critical_points.emplace_back();
    points.critical_points.back().index = index;
    points.critical_points.back().elem = elem;
  }
  EXPECT_TRUE(has_opposite_nodes(points, {}));
  EXPECT_TRUE(has_opposite_nodes(points, {0, 4, 8}));
  EXPECT_FALSE(has_opposite_nodes(points, {0, 6, 8}));
  points.critical_points.back().source = NodeSource::divide;
  EXPECT_FALSE(has_opposite_nodes(points, {}));
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
