#include "placement/node_symmetry.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"
#include "node_samples.hpp"

namespace quadrille::placement {
namespace {

using namespace testing_faces;

/// A rectangle of 4 x 2 about (0, 0): it has the identity, the half turn and two reflections.
CadFace rectangle() { return make_face({polygon({{-2, -1}, {2, -1}, {2, 1}, {-2, 1}})}); }

std::size_t num_symmetries(const CriticalPoints& points, std::vector<bool> is_free = {}) {
  is_free.resize(points.critical_points.size(), is_free.empty());
  return node_symmetries(rectangle(), points, is_free).size();
}

TEST(NodeSymmetries, are_those_of_the_face_that_keep_all_nodes) {
  EXPECT_EQ(num_symmetries(points_at({{1, 0.5}, {-1, 0.5}, {-1, -0.5}, {1, -0.5}})), 4u);
  EXPECT_EQ(num_symmetries(points_at({{1, 0.5}, {-1, -0.5}})), 2u);
  EXPECT_EQ(num_symmetries(points_at({{1, 0.5}, {-1, 0.5}})), 2u);
  EXPECT_EQ(num_symmetries(points_at({{1, 0.5}, {-0.9, 0.5}})), 1u);
  EXPECT_EQ(num_symmetries(points_at({{0, 0}})), 4u);
}

TEST(NodeSymmetries, keep_valences_and_freedom_and_the_boundary) {
  CriticalPoints points = points_at({{1, 0}, {-1, 0}});
  EXPECT_EQ(num_symmetries(points), 4u);
  EXPECT_EQ(num_symmetries(points, {true, false}), 2u);
  points.critical_points[0].valence = 5;
  EXPECT_EQ(num_symmetries(points), 2u);
  points.critical_points[0].valence = 3;
  for (int j = 0; j < 4; ++j) {
    points.corners.emplace_back();
    points.corners.back().position = rectangle().joints[j].position;
    points.corners.back().valence = 1;
  }
  EXPECT_EQ(num_symmetries(points), 4u);
  points.corners[2].valence = 2;
  EXPECT_EQ(num_symmetries(points), 1u);
  points.corners[1].valence = 2;
  EXPECT_EQ(num_symmetries(points), 2u);
  points.hole_winding_offsets = {1};
  EXPECT_EQ(num_symmetries(points), 1u);
}

TEST(NodeSymmetries, corners_on_both_sides_of_a_slit_are_in_one_place) {
  CriticalPoints points = points_at({{1, 0.5}, {1, -0.5}});
  for (int k = 0; k < 2; ++k) {
    points.corners.emplace_back();
    points.corners.back().position = {2, 0};
    points.corners.back().valence = 1;
  }
  EXPECT_EQ(num_symmetries(points), 2u);
}

TEST(NodeSymmetries, can_be_made_exact) {
  CriticalPoints points = points_at({{1 + 1e-7, 0.5}, {-1, 0.5 + 2e-7}, {-1 - 1e-7, -0.5}, {1, -0.5}});
  const std::vector<bool> is_free(4, true);
  symmetrise(node_symmetries(rectangle(), points, is_free), is_free, points);
  const Vec2 x = points.critical_points[0].position;
  EXPECT_NEAR(distance(x, {1 + 5e-8, 0.5 + 5e-8}), 0, 1e-13);
  EXPECT_NEAR(distance(points.critical_points[1].position, {-x.x, x.y}), 0, 1e-15);
  EXPECT_NEAR(distance(points.critical_points[2].position, -x), 0, 1e-15);
  EXPECT_NEAR(distance(points.critical_points[3].position, {x.x, -x.y}), 0, 1e-15);
}

TEST(InvariantMovements, leave_as_many_ways_as_the_symmetry) {
  const auto num_ways = [](const std::vector<Vec2>& places) {
    const std::vector<bool> is_free(places.size(), true);
    return invariant_movements(node_symmetries(rectangle(), points_at(places), is_free), is_free).cols();
  };
  EXPECT_EQ(num_ways({{1, 0.5}, {-1, 0.5}, {-1, -0.5}, {1, -0.5}}), 2);
  EXPECT_EQ(num_ways({{1, 0}, {-1, 0}}), 1);
  EXPECT_EQ(num_ways({{0, 0}}), 0);
  EXPECT_EQ(num_ways({{1, 0.5}, {-0.9, 0.5}}), 4);
  EXPECT_EQ(num_ways({{1, 0}, {-1, 0}, {0, 0.5}, {0, -0.5}, {0, 0}}), 2);
}

TEST(InvariantMovements, are_images_of_each_other) {
  const std::vector<bool> is_free{true, false, true};
  const CriticalPoints points = points_at({{1, 0.5}, {0, 0}, {-1, 0.5}});
  const Eigen::MatrixXd ways = invariant_movements(node_symmetries(rectangle(), points, is_free), is_free);
  ASSERT_EQ(ways.rows(), 4);
  ASSERT_EQ(ways.cols(), 2);
  EXPECT_NEAR((ways.row(0) + ways.row(2)).norm(), 0, 1e-14);
  EXPECT_NEAR((ways.row(1) - ways.row(3)).norm(), 0, 1e-14);
  EXPECT_NEAR((ways.transpose() * ways - Eigen::MatrixXd::Identity(2, 2)).norm(), 0, 1e-14);
}

using namespace testing_faces;
using Eigen::VectorXd;

/// Nodes 0 and 2 move as mirror images about the y axis, node 1 does not.
ReducedCoordinates mirrored_pair() {
  const double h = std::sqrt(0.5);
  ReducedCoordinates coordinates{{0, 2}, Eigen::MatrixXd::Zero(4, 2), {0.5, 0, 2}};
  coordinates.movements.col(0) << h, 0, -h, 0;
  coordinates.movements.col(1) << 0, h, 0, h;
  return coordinates;
}

TEST(ReducedCoordinates, move_each_node_in_its_own_scale) {
  const std::vector<Vec2> moves = mirrored_pair().movement(std::sqrt(2.0) * Eigen::Vector2d{1, 3});
  ASSERT_EQ(moves.size(), 3u);
  EXPECT_NEAR(distance(moves[0], {0.5, 1.5}), 0, 1e-15);
  EXPECT_EQ(moves[1], Vec2{});
  EXPECT_NEAR(distance(moves[2], {-2, 6}), 0, 1e-14);
}

TEST(ReducedCoordinates, moved_nodes_keep_all_but_their_places) {
  const CriticalPoints base = points_at({{1, 1}, {0, 0}, {-1, 1}});
  const CriticalPoints moved = mirrored_pair().moved(base, std::sqrt(2.0) * Eigen::Vector2d{1, 0});
  EXPECT_NEAR(distance(moved.critical_points[0].position, {1.5, 1}), 0, 1e-15);
  EXPECT_EQ(moved.critical_points[1].position, (Vec2{0, 0}));
  EXPECT_NEAR(distance(moved.critical_points[2].position, {-3, 1}), 0, 1e-15);
  EXPECT_EQ(moved.critical_points[0].valence, 3);
}

TEST(ReducedCoordinates, their_gradient_is_that_of_the_moved_function) {
  // f = sum of g_k . x_k: linear, so that its slope along y is exact.
  const std::vector<Vec2> g{{1, 2}, {30, 40}, {-5, 7}};
  const ReducedCoordinates coordinates = mirrored_pair();
  const VectorXd slope = coordinates.gradient(g);
  ASSERT_EQ(slope.size(), 2);
  for (Eigen::Index i = 0; i < 2; ++i) {
    const std::vector<Vec2> moves = coordinates.movement(VectorXd::Unit(2, i));
    double change = 0;
    for (int k = 0; k < 3; ++k) change += dot(g[k], moves[k]);
    EXPECT_NEAR(slope[i], change, 1e-13);
  }
}

TEST(LengthScales, are_distances_to_the_nearest_node_or_boundary_point) {
  const CadFace face = make_face({polygon({{-2, -1}, {2, -1}, {2, 1}, {-2, 1}})});
  const SmoothBoundaryDistance boundary(face);
  const CriticalPoints points = points_at({{1.7, 0}, {0, 0}, {0.2, 0.1}});
  const std::vector<NodeSymmetry> alone = node_symmetries(face, points, {true, true, false});
  const std::vector<double> scales = length_scales(boundary, points, {0, 1}, alone);
  ASSERT_EQ(scales.size(), 3u);
  EXPECT_NEAR(scales[0], 0.3, 1e-6);
  EXPECT_NEAR(scales[1], std::sqrt(0.05), 1e-6);  // node 2 is near, though not free
  EXPECT_EQ(scales[2], 0);
}

TEST(LengthScales, of_images_are_equal_to_the_last_bit) {
  const CadFace face = make_face({polygon({{-2, -1}, {2, -1}, {2, 1}, {-2, 1}})});
  const SmoothBoundaryDistance boundary(face);
  const CriticalPoints points = points_at({{1.5 + 2e-7, 0}, {-1.5, 0}});
  const std::vector<bool> is_free{true, true};
  const std::vector<double> scales = length_scales(boundary, points, {0, 1}, node_symmetries(face, points, is_free));
  EXPECT_EQ(scales[0], scales[1]);
  EXPECT_NEAR(scales[0], 0.5 - 1e-7, 1e-9);
}

}  // namespace
}  // namespace quadrille::placement
