#include "placement/reduced_coordinates.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"
#include "node_samples.hpp"

namespace quadrille::placement {
namespace {

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
