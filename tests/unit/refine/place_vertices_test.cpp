#include "refine/place_vertices.hpp"

#include <gtest/gtest.h>

#include "refine/best_split.hpp"
#include "split_samples.hpp"

namespace quadrille::refine {
namespace {

TEST(PlaceVertices, NoneMovesWithoutLayersAndRelaxation) {
  const SplitSample sample(hand_made::s_bend(), {.size = 0.45, .order = 3});
  SplitMesh split = best_split(sample.request).split;
  const std::vector<Vec2> before = split.mesh.nodes;
  place_vertices(sample.request, split);
  EXPECT_EQ(split.mesh.nodes, before);
}

TEST(PlaceVertices, RelaxationNeverLowersTheLeastScaledJacobian) {
  const SplitSample sample(hand_made::s_bend(), {.size = 0.45, .order = 3, .relax = 5});
  SplitMesh split = best_split(sample.request).split;
  const double before = std::ranges::min(split.mesh.elem_scaled_jacobian);
  place_vertices(sample.request, split);
  EXPECT_GE(std::ranges::min(split.mesh.elem_scaled_jacobian), before - 1e-6);
  EXPECT_TRUE(split.distance.is_within(sample.request.limits.distance));
}

/// The upper half of a C-grid: the wall turns by a right angle at its nose, within a tenth of its length, the far field
/// along most of its own. Lines that connect equal fractions of both are oblique to the layers.
SeparatrixGraph half_c_grid() {
  SeparatrixGraph g = hand_made::one_block(
      hand_made::face({{curve::circular_arc({0.1, 0}, 0.1, pi, pi / 2), curve::segment({0.1, 0.1}, {1.5, 0.1}),
                        curve::segment({1.5, 0.1}, {1.5, 6}), curve::segment({1.5, 6}, {1, 6}),
                        curve::circular_arc({1, 0}, 6, pi / 2, pi), curve::segment({-5, 0}, {0, 0})}},
                      9),
      {{0, 1}, {2}, {3, 4}, {5}});
  g.face.curve_names[0] = g.face.curve_names[1] = "wall";
  return g;
}

TEST(PlaceVertices, ObliqueLinesAlongAWallAreStraightened) {
  RefineOptions options{.size = 0.5, .order = 2};
  options.walls = {layers::parse_wall_spec("wall:first=0.01,layers=4,growth=1.2")};
  const SplitSample sample(half_c_grid(), options);
  SplitMesh split = best_split(sample.request).split;
  ASSERT_TRUE(split.growth);
  const mesh::MeshScore before = split.score;
  ASSERT_GT(before.skewness, 0);
  place_vertices(sample.request, split);
  EXPECT_TRUE(mesh::is_better(split.score, before));
  EXPECT_FALSE(split.lines.shifts.empty());
}

TEST(PlaceVertices, LinesThatNeedNoCorrectionStay) {
  RefineOptions options{.size = 0.2, .order = 2};
  const SeparatrixGraph square = square_with_wall(options);
  const SplitSample sample(square, options);
  SplitMesh split = best_split(sample.request).split;
  ASSERT_TRUE(split.growth);
  ASSERT_EQ(split.score.growth, 0) << "nothing is to be improved";
  const std::vector<Vec2> before = split.mesh.nodes;
  place_vertices(sample.request, split);
  EXPECT_EQ(split.mesh.nodes, before);
}

}  // namespace
}  // namespace quadrille::refine
