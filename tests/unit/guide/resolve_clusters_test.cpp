#include "guide/resolve_clusters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "../triangulate/faces.hpp"
#include "base/angle.hpp"
#include "curve/face_boundary.hpp"
#include "curve/symmetry.hpp"
#include "guide/complete_nodes.hpp"

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

using namespace testing_faces;

CadFace regular_polygon(int n) {
  std::vector<Vec2> points;
  for (int k = 0; k < n; ++k) points.push_back(unit(2 * pi * k / n));
  return make_face({polygon(points)});
}

CadFace disc() { return make_face({circle({0, 0}, 1)}); }

Cluster multiple_zero(Vec2 centre, int index) { return {centre, 0, index, {centre}, {}}; }

/// Zeros that stand apart, about their mean.
Cluster zeros_at(const std::vector<Vec2>& places, int index_of_each) {
  Cluster cluster;
  for (const Vec2 x : places) cluster.centre += x / static_cast<double>(places.size());
  for (const Vec2 x : places) cluster.radius = std::max(cluster.radius, distance(x, cluster.centre));
  cluster.index = index_of_each * static_cast<int>(places.size());
  cluster.members = places;
  cluster.member_indices.assign(places.size(), index_of_each);
  return cluster;
}

CriticalPoints resolved(const CadFace& face, const std::vector<Cluster>& clusters, int max_valence = 6) {
  CriticalPoints points;
  points.clusters = clusters;
  resolve_clusters(face, max_valence, points);
  return points;
}

bool has_node_at(const CriticalPoints& points, Vec2 x, double tol) {
  return std::any_of(points.critical_points.begin(), points.critical_points.end(),
                     [&](const CriticalPoint& p) { return distance(p.position, x) < tol; });
}

bool is_invariant(const CriticalPoints& points, const curve::Isometry& g, double tol) {
  return std::all_of(points.critical_points.begin(), points.critical_points.end(),
                     [&](const CriticalPoint& p) { return has_node_at(points, g(p.position), tol); });
}

int num_symmetries(const CadFace& face, const CriticalPoints& points) {
  const std::vector<curve::Isometry> group = curve::symmetries(face);
  return static_cast<int>(std::count_if(group.begin(), group.end(), [&](const curve::Isometry& g) {
    return is_invariant(points, g, 1e-10 * face.diameter);
  }));
}

int index_of(const std::vector<NodeMark>& marks) {
  int sum = 0;
  for (const NodeMark& m : marks) sum += 4 - m.valence;
  return sum;
}

TEST(ResolveClusters, disc_gets_the_four_nodes_of_an_o_grid) {
  const CadFace face = disc();
  const CriticalPoints points = resolved(face, {multiple_zero({1e-8, -2e-9}, 4)});
  ASSERT_EQ(points.critical_points.size(), 4u);
  for (const CriticalPoint& p : points.critical_points) {
    EXPECT_EQ(p.valence, 3);
    EXPECT_EQ(p.index, 1);
    EXPECT_EQ(p.source, NodeSource::cluster);
    EXPECT_NEAR(norm(p.position), 0.5, 1e-12);
  }
  EXPECT_TRUE(has_node_at(points, {0.5, 0}, 1e-12));  // towards joint 0, where a block may begin
  EXPECT_EQ(num_symmetries(face, points), 8);
  EXPECT_EQ(points.form, NodeForm::phase);
  EXPECT_EQ(points.index_sum, 4);
  ASSERT_EQ(points.changes.size(), 1u);
  EXPECT_EQ(points.changes[0].kind, ChangeKind::cluster);
  EXPECT_EQ(index_of(points.changes[0].before), 4);
  EXPECT_EQ(index_of(points.changes[0].after), 4);
}

TEST(ResolveClusters, noise_that_splits_a_multiple_zero_does_not_decide) {
  const CadFace face = disc();
  std::vector<Vec2> places;
  for (int k = 0; k < 4; ++k) places.push_back(3e-3 * unit(0.6 + k * half_pi));
  const CriticalPoints points = resolved(face, {zeros_at(places, 1)});
  EXPECT_TRUE(has_node_at(points, {0.5, 0}, 1e-12));
  EXPECT_EQ(num_symmetries(face, points), 8);
}

TEST(ResolveClusters, hexagon_keeps_one_node_of_valence_6_where_that_is_allowed) {
  const CadFace face = regular_polygon(6);
  const CriticalPoints one = resolved(face, {multiple_zero({0, 0}, -2)});
  ASSERT_EQ(one.critical_points.size(), 1u);
  EXPECT_EQ(one.critical_points[0].valence, 6);
  EXPECT_LT(norm(one.critical_points[0].position), 1e-15);
  EXPECT_EQ(one.form, NodeForm::phase);

  const CriticalPoints two = resolved(face, {multiple_zero({0, 0}, -2)}, 5);
  ASSERT_EQ(two.critical_points.size(), 2u);
  EXPECT_EQ(two.critical_points[0].valence, 5);
  EXPECT_EQ(num_symmetries(face, two), 4);  // D2, the largest that D6 and a pair share
  const Vec2 x = two.critical_points[0].position;
  EXPECT_NEAR(norm(x), std::sqrt(3) / 4, 1e-12);
  EXPECT_NEAR(std::abs(std::remainder(angle_of(x), pi / 3)), pi / 6, 1e-12);  // towards the near sides
}

TEST(ResolveClusters, ring_has_the_largest_group_it_can_share) {
  EXPECT_EQ(num_symmetries(square(), resolved(square(), {multiple_zero({0.5, 0.5}, 4)})), 8);
  EXPECT_EQ(num_symmetries(square(), resolved(square(), {multiple_zero({0.5, 0.5}, 3)})), 2);
  EXPECT_EQ(num_symmetries(regular_polygon(8), resolved(regular_polygon(8), {multiple_zero({0, 0}, 4)})), 8);
  EXPECT_EQ(num_symmetries(regular_polygon(6), resolved(regular_polygon(6), {multiple_zero({0, 0}, 3)})), 6);
  EXPECT_EQ(num_symmetries(stadium(), resolved(stadium(), {multiple_zero({0, 0}, 4)})), 4);
  EXPECT_EQ(num_symmetries(half_disc(), resolved(half_disc(), {multiple_zero({0, 0.4}, 2)})), 2);
  const CadFace parallelogram = make_face({polygon({{0, 0}, {2, 0}, {3, 1}, {1, 1}})});
  EXPECT_EQ(num_symmetries(parallelogram, resolved(parallelogram, {multiple_zero({1.5, 0.5}, 2)})), 2);
}

TEST(ResolveClusters, nodes_of_valence_3_go_where_the_room_is) {
  const CriticalPoints in_square = resolved(square(), {multiple_zero({0.5, 0.5}, 4)});
  EXPECT_TRUE(has_node_at(in_square, Vec2{0.5, 0.5} + 0.25 * unit(pi / 4), 1e-12));
  const CriticalPoints in_stadium = resolved(stadium(), {multiple_zero({0, 0}, 2)});
  EXPECT_TRUE(has_node_at(in_stadium, {0.5, 0}, 1e-12));
  const CriticalPoints of_valence_5 = resolved(stadium(), {multiple_zero({0, 0}, -2)}, 5);
  EXPECT_TRUE(has_node_at(of_valence_5, {0, 0.5}, 1e-12));
}

TEST(ResolveClusters, members_that_stand_out_of_noise_decide) {
  const Vec2 c{0.4, 0.7};
  const CadFace face = make_face({polygon({{0, 0}, {3, 0}, {2, 1.5}, {0, 1.3}})});
  for (const double angle : {0.1, 1.0, 2.5}) {
    const CriticalPoints points = resolved(face, {zeros_at({c + 0.01 * unit(angle), c - 0.01 * unit(angle)}, 1)});
    ASSERT_EQ(points.critical_points.size(), 2u);
    EXPECT_NEAR(cross(points.critical_points[0].position - c, unit(angle)), 0, 1e-12);
    EXPECT_NEAR(distance(points.critical_points[0].position, c), 0.2, 1e-12);  // half of the room
  }
  const CriticalPoints across = resolved(stadium(), {zeros_at({{0, 0.01}, {0, -0.01}}, 1)});
  EXPECT_TRUE(has_node_at(across, {0, 0.5}, 1e-12));
}

TEST(ResolveClusters, pairs_cancel) {
  CriticalPoints points;
  CriticalPoint a, b, other;
  a.position = {0.5, 0.5}, a.index = 1, a.valence = 3;
  b.position = {0.501, 0.5}, b.index = -1, b.valence = 5;
  other.position = {0.2, 0.2}, other.index = 1, other.valence = 3;
  points.critical_points = {other};
  points.zeros = {a, b, other};
  points.clusters = {{{0.5005, 0.5}, 5e-4, 0, {a.position, b.position}, {1, -1}}};
  resolve_clusters(square(), 6, points);
  ASSERT_EQ(points.critical_points.size(), 1u);
  EXPECT_EQ(points.critical_points[0].position, other.position);
  ASSERT_EQ(points.changes.size(), 1u);
  EXPECT_EQ(points.changes[0].kind, ChangeKind::cancel);
  EXPECT_EQ(points.changes[0].before.size(), 2u);
  EXPECT_TRUE(points.changes[0].after.empty());
  EXPECT_EQ(points.zeros.size(), 3u);
  EXPECT_EQ(points.index_sum, 1);
}

TEST(ResolveClusters, nothing_to_do_changes_nothing) {
  CriticalPoints points;
  points.critical_points.resize(1);
  resolve_clusters(square(), 6, points);
  EXPECT_EQ(points.form, NodeForm::harmonic);
  EXPECT_EQ(points.critical_points.size(), 1u);
  EXPECT_TRUE(points.zeros.empty());
}

TEST(ResolveClusters, clusters_of_one_orbit_are_resolved_alike) {
  // Off the axes, where each alone would look for a nearest boundary point; centres with noise.
  std::vector<Cluster> clusters;
  const Vec2 c{0.5, 0.5}, off{0.31, 0.12};
  int noise = 0;
  for (const curve::Isometry& g : curve::symmetries(square()))
    clusters.push_back(multiple_zero(g(c + off) + 1e-9 * unit(++noise), 2));
  const CriticalPoints points = resolved(square(), clusters);
  EXPECT_EQ(points.critical_points.size(), 16u);
  EXPECT_EQ(num_symmetries(square(), points), 8);
}

TEST(ResolveClusters, moved_faces_get_moved_nodes) {
  struct Case {
    CadFace face;
    Cluster cluster;
  };
  const std::vector<Case> cases = {
      {disc(), multiple_zero({0, 0}, 4)},
      {stadium(), multiple_zero({0, 0}, 4)},
      {half_disc(), multiple_zero({0, 0.4}, 2)},
      {l_shape(), multiple_zero({0.6, 0.6}, 3)},
      {make_face({polygon({{0, 0}, {3, 0}, {2, 1.5}, {0, 1.3}})}), multiple_zero({0.7, 0.6}, 2)}};
  for (const Case& c : cases)
    for (const bool mirrored : {false, true})
      for (const double scale : {1e-3, 1.0, 1e3}) {
        const Vec2 shift = scale * Vec2{3, -2};
        const double angle = radians(37);
        const auto h = [&](Vec2 x) { return scale * curve::Isometry{{0, 0}, angle, mirrored}.turned(x) + shift; };
        const CadFace image = moved(c.face, scale, angle, shift, mirrored);
        Cluster moved_cluster = c.cluster;
        moved_cluster.centre = moved_cluster.members[0] = h(c.cluster.centre);
        const CriticalPoints here = resolved(c.face, {c.cluster}), there = resolved(image, {moved_cluster});
        ASSERT_EQ(here.critical_points.size(), there.critical_points.size());
        for (const CriticalPoint& p : here.critical_points)
          EXPECT_TRUE(has_node_at(there, h(p.position), 1e-10 * image.diameter));
      }
}

TEST(ResolveClusters, index_sum_is_kept_and_nodes_stay_inside_on_random_polygons) {
  std::mt19937 random(5);
  const auto between = [&](double a, double b) { return a + (b - a) * static_cast<double>(random() % 1000) / 1000; };
  for (int trial = 0; trial < 100; ++trial) {
    const int n = 3 + static_cast<int>(random() % 7);
    std::vector<Vec2> outline;
    for (int k = 0; k < n; ++k) outline.push_back(between(1, 2) * unit(2 * pi * k / n));
    const CadFace face = make_face({polygon(outline), hole({0, 0}, 0.1)});
    std::vector<Cluster> clusters;
    int sum = 0;
    for (int k = 0; k < 3; ++k) {
      const int index = static_cast<int>(random() % 11) - 5;
      const Vec2 x = between(0.15, 0.4) * unit(2.1 * k + between(0, 0.5));
      clusters.push_back(multiple_zero(x, index));
      sum += index;
    }
    const CriticalPoints points = resolved(face, clusters, 3 + static_cast<int>(random() % 4));
    EXPECT_EQ(points.index_sum, sum);
    EXPECT_EQ(index_sum_of(points), sum);
    for (const NodeChange& change : points.changes) EXPECT_EQ(index_of(change.before), index_of(change.after));
    for (std::size_t i = 0; i < points.critical_points.size(); ++i) {
      EXPECT_GT(curve::FaceBoundary(face).signed_distance(points.critical_points[i].position), 0);
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_GT(distance(points.critical_points[i].position, points.critical_points[j].position), 1e-3);
    }
  }
}

TEST(ResolveClusters, nodes_of_clusters_far_from_the_boundary_are_not_moved) {
  Cluster cluster = multiple_zero({0, 0}, -4);
  for (const bool is_far : {false, true}) {
    cluster.is_far_from_boundary = is_far;
    const CriticalPoints points = resolved(disc(), {cluster});
    ASSERT_EQ(points.critical_points.size(), 4u);
    EXPECT_EQ(points.critical_points[0].source, is_far ? NodeSource::cancel : NodeSource::cluster);
    EXPECT_EQ(points.changes[0].kind, is_far ? ChangeKind::cancel : ChangeKind::cluster);
    EXPECT_EQ(nodes_without_position(disc(), points), std::vector<bool>(4, !is_far));
  }
}

}  // namespace
}  // namespace quadrille::guide
