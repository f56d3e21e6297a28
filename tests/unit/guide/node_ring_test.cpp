#include "guide/node_ring.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"

namespace quadrille::guide {
namespace {

using namespace testing_faces;

const std::vector<curve::Isometry> identity{{{0, 0}, 0, false}};

Cluster cluster_at(Vec2 centre, int index) { return {centre, 0, index, {centre}, {}}; }

TEST(OntoFixedPoints, MovesPointsNearTheCentreOrAnAxisAndNoOthers) {
  const std::vector<curve::Isometry> group = curve::symmetries(square());
  EXPECT_LT(distance(onto_fixed_points(square(), group, {0.5 + 1e-7, 0.5}), {0.5, 0.5}), 1e-12);
  EXPECT_NEAR(onto_fixed_points(square(), group, {0.3, 0.5 + 1e-7}).x, 0.3, 1e-12);
  EXPECT_NEAR(onto_fixed_points(square(), group, {0.3, 0.5 + 1e-7}).y, 0.5, 1e-12);
  EXPECT_EQ(onto_fixed_points(square(), group, {0.3, 0.4}), (Vec2{0.3, 0.4}));
}

TEST(NodeRing, IsTheCentreForIndexOne) {
  EXPECT_EQ(node_ring(square(), identity, cluster_at({0.3, 0.4}, 1), {}), (std::vector<Vec2>{{0.3, 0.4}}));
}

TEST(NodeRing, HasHalfTheClearanceAsRadiusAtMostAThirdOfTheDistanceToOthers) {
  const Cluster cluster = cluster_at({0.5, 0.4}, 3);
  for (const Vec2 x : node_ring(square(), identity, cluster, {})) EXPECT_NEAR(distance(x, cluster.centre), 0.2, 1e-12);
  for (const Vec2 x : node_ring(square(), identity, cluster, {{0.5, 0.55}}))
    EXPECT_NEAR(distance(x, cluster.centre), 0.05, 1e-12);
}

TEST(NodeRing, PointsToOrFromTheNearestBoundaryWhereThereIsNoMirror) {
  // Towards the nearest side a vertex has clearance 0.4, away from it 0.6: nodes of valence 3 have room, of 5 do not.
  const auto far = node_ring(square(), identity, cluster_at({0.5, 0.4}, 3), {});
  EXPECT_TRUE(std::any_of(far.begin(), far.end(), [](Vec2 x) { return distance(x, {0.5, 0.6}) < 1e-9; }));
  const auto near = node_ring(square(), identity, cluster_at({0.5, 0.4}, -3), {});
  EXPECT_TRUE(std::any_of(near.begin(), near.end(), [](Vec2 x) { return distance(x, {0.5, 0.2}) < 1e-9; }));
}

TEST(NodeRing, SurroundsAHoleWhereTheCentreIsOutside) {
  const std::vector<Vec2> ring = node_ring(annulus(), identity, cluster_at({0, 0}, -4), {});
  ASSERT_EQ(ring.size(), 4u);
  for (const Vec2 x : ring) EXPECT_NEAR(norm(x), 0.75, 0.01);  // radii 0.5 and 1
}

TEST(ClusterNodes, AreOneNodeWhereTheValenceIsAllowed) {
  const auto nodes = [&](int index, int max_valence) {
    return cluster_nodes(square(), identity, max_valence, cluster_at({0.5, 0.5}, index), {}, NodeSource::cluster);
  };
  EXPECT_EQ(nodes(-2, 6).size(), 1u);
  EXPECT_EQ(nodes(-2, 6)[0].valence, 6);
  EXPECT_EQ(nodes(-2, 5).size(), 2u);
  EXPECT_EQ(nodes(2, 6).size(), 2u);  // valence 2 is no node
  EXPECT_EQ(nodes(2, 6)[0].valence, 3);
  EXPECT_EQ(nodes(2, 6)[0].source, NodeSource::cluster);
}

}  // namespace
}  // namespace quadrille::guide
