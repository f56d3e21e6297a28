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

TEST(PlaceVertices, RelaxationChangesTheReportAndNeverTheWorstElementForTheWorse) {
  const SplitSample sample(hand_made::s_bend(), {.size = 0.45, .order = 3, .relax = 5});
  SplitMesh split = best_split(sample.request).split;
  const double before = std::ranges::min(split.mesh.elem_scaled_jacobian);
  place_vertices(sample.request, split);
  EXPECT_GE(std::ranges::min(split.mesh.elem_scaled_jacobian), before - 1e-6);
  EXPECT_TRUE(split.distance.is_within(sample.request.limits.distance));
}

/// A block whose lower side, a wall, is a half circle and whose upper side is a flat arc: lines that connect equal
/// fractions of both are oblique to the layers.
SeparatrixGraph nose() {
  SeparatrixGraph g = hand_made::one_block(
      hand_made::face(
          {{curve::circular_arc({0, 0}, 1, pi, 0), curve::segment({1, 0}, {6, 0}), curve::segment({6, 0}, {6, 4}),
            curve::segment({6, 4}, {-6, 4}), curve::segment({-6, 4}, {-6, 0}), curve::segment({-6, 0}, {-1, 0})}},
          13),
      {{0}, {1}, {2, 3, 4}, {5}});
  g.face.curve_names[0] = "wall";
  return g;
}

TEST(PlaceVertices, LinesAlongWallsAreKeptIfTheyImproveTheScore) {
  RefineOptions options{.size = 0.6, .order = 2};
  options.walls = {layers::parse_wall_spec("wall:first=0.01,layers=4,growth=1.2")};
  const SplitSample sample(nose(), options);
  SplitMesh split = best_split(sample.request).split;
  ASSERT_TRUE(split.growth);
  const mesh::MeshScore before = split.score;
  place_vertices(sample.request, split);
  EXPECT_FALSE(mesh::is_better(before, split.score));
  EXPECT_EQ(mesh::is_better(split.score, before), !split.lines.shifts.empty() || !split.lines.factors.empty());
}

}  // namespace
}  // namespace quadrille::refine
