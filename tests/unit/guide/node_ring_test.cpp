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
    return cluster_nodes(square(), identity, max_valence, cluster_at({0.5, 0.5}, index), {});
  };
  EXPECT_EQ(nodes(-2, 6).size(), 1u);
  EXPECT_EQ(nodes(-2, 6)[0].valence, 6);
  EXPECT_EQ(nodes(-2, 5).size(), 2u);
  EXPECT_EQ(nodes(2, 6).size(), 2u);  // valence 2 is no node
  EXPECT_EQ(nodes(2, 6)[0].valence, 3);
}

TEST(NodesOfClusters, AreExactImagesInOneOrbitAndNoneForIndexZero) {
  std::vector<Cluster> clusters = {cluster_at({0.2, 0.3}, 2), cluster_at({0.8 + 1e-8, 0.3}, 2),
                                   cluster_at({0.5, 0.5 + 1e-8}, 0), cluster_at({0.3, 0.2}, -2)};
  const std::vector<curve::Isometry> group = curve::symmetries(square());
  std::vector<std::size_t> asked;
  const auto nodes = nodes_of_clusters(square(), group, 5, clusters, [&](std::size_t i) {
    asked.push_back(i);
    return std::vector<Vec2>{};
  });
  EXPECT_EQ(asked, (std::vector<std::size_t>{0, 3}));
  EXPECT_NEAR(clusters[1].centre.x, 0.8, 1e-14);
  EXPECT_NEAR(clusters[2].centre.y, 0.5, 1e-14);
  ASSERT_EQ(nodes[0].size(), 2u);
  ASSERT_EQ(nodes[1].size(), 2u);
  for (int k = 0; k < 2; ++k)
    EXPECT_NEAR(distance(nodes[1][k].position, {1 - nodes[0][k].position.x, nodes[0][k].position.y}), 0, 1e-14);
  EXPECT_TRUE(nodes[2].empty());
  EXPECT_EQ(nodes[3][0].valence, 5);
}

}  // namespace
}  // namespace quadrille::guide
