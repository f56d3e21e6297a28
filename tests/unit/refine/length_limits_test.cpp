#include "refine/length_limits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "block/extract_blocks.hpp"
#include "refine/validity.hpp"
#include "split_samples.hpp"

namespace quadrille::refine {
namespace {

double shortest(const SeparatrixGraph& graph) {
  Report report;
  const BlockLayout layout = block::extract_blocks(graph, report);
  return shortest_kept_edge(sizing::MeasuredLayout(layout));
}

TEST(ShortestKeptEdge, lies_between_two_corners) { EXPECT_NEAR(shortest(hand_made::row({2, 0.25, 1})), 0.25, 1e-12); }

TEST(ShortestKeptEdge, passes_nodes_that_are_no_corners) {
  // The lower side of the L, of length 2, has a node in its middle; its shortest sides have length 1.
  EXPECT_NEAR(shortest(hand_made::l_shape()), 1, 1e-12);
}

TEST(ShortestKeptEdge, ends_at_joints_of_names) {
  // A square whose lower side consists of three lines.
  SeparatrixGraph square = hand_made::one_block(
      hand_made::face(
          {{curve::segment({0, 0}, {0.5, 0}), curve::segment({0.5, 0}, {0.6, 0}), curve::segment({0.6, 0}, {1, 0}),
            curve::segment({1, 0}, {1, 1}), curve::segment({1, 1}, {0, 1}), curve::segment({0, 1}, {0, 0})}},
          std::sqrt(2.0)),
      {{0, 1, 2}, {3}, {4}, {5}});
  square.face.curve_names.assign(6, "wall");
  EXPECT_NEAR(shortest(square), 1, 1e-12);
  square.face.curve_names[2] = "inlet";
  EXPECT_NEAR(shortest(square), 0.4, 1e-12);
  square.face.curve_names[0] = "inlet";
  EXPECT_NEAR(shortest(square), 0.1, 1e-12);
}

TEST(ShortestKeptEdge, does_not_exist_without_corners) { EXPECT_TRUE(std::isinf(shortest(hand_made::cut_annulus(4)))); }

RefineOptions with_size(double size) {
  RefineOptions options;
  options.size = size;
  options.order = 2;
  options.relax = Relax::none;
  return options;
}

double greatest_ratio(const QuadMesh& mesh) {
  return *std::max_element(mesh.elem_edge_ratio.begin(), mesh.elem_edge_ratio.end());
}

/// The x of the vertices on the lower side, ascending.
std::vector<double> vertices_below(const QuadMesh& mesh) {
  std::vector<double> x{0};
  for (const QuadBoundaryEdge& edge : mesh.boundary_edges) {
    if (edge.curve != 0) continue;
    const std::vector<Vec2> nodes = element_nodes(mesh, edge.elem);
    double right = 0;
    for (const Vec2 p : nodes)
      if (p.y == 0) right = std::max(right, p.x);
    x.push_back(right);
  }
  std::sort(x.begin(), x.end());
  return x;
}

TEST(LengthLimits, elements_of_a_thin_block_become_shorter) {
  EXPECT_LE(greatest_ratio(refined(divided_square(1e-3, 1e-3), with_size(0.25))), 100);
}

TEST(LengthLimits, elements_of_a_thick_block_keep_their_size) {
  EXPECT_EQ(refined(divided_square(0.25, 0.25), with_size(0.25)).num_elems(), 16);
}

TEST(LengthLimits, away_from_the_thin_place_elements_have_the_prescribed_size) {
  const QuadMesh mesh = refined(divided_square(1e-3, 0.5), with_size(0.25));
  EXPECT_LE(greatest_ratio(mesh), 100);
  const std::vector<double> x = vertices_below(mesh);
  const std::size_t last = x.size() - 1;
  EXPECT_LT(x[1] - x[0], 0.1);
  EXPECT_GT(x[last] - x[last - 1], 0.125);
}

TEST(LengthLimits, elements_at_a_short_edge_between_corners_become_shorter_if_few_suffice) {
  // 3 h / e = 375 is no limit here, and 125 the ratio.
  const QuadMesh mesh = refined(hand_made::row({2e-3, 1}), with_size(0.25));
  EXPECT_LE(greatest_ratio(mesh), 100);
  EXPECT_GT(mesh.num_elems(), 4 + 16);
  EXPECT_LE(mesh.num_elems(), 2 * (4 + 16));
}

TEST(LengthLimits, elements_at_a_shorter_edge_between_corners_keep_their_size) {
  // 3 h / e = 750 is the limit, and 250 the ratio. To lower it to 100 takes more than twice as many elements.
  EXPECT_EQ(refined(hand_made::row({1e-3, 1}), with_size(0.25)).num_elems(), 4 + 16);
}

TEST(LengthLimits, the_target_is_an_option) {
  RefineOptions options = with_size(0.25);
  options.target_edge_ratio = 0;
  EXPECT_EQ(refined(divided_square(1e-3, 1e-3), options).num_elems(), 4 + 16);
  options.target_edge_ratio = 20;
  EXPECT_LE(greatest_ratio(refined(divided_square(0.01, 0.01), options)), 20);
}

TEST(LengthLimits, prescribed_counts_stay) {
  RefineOptions options = with_size(0.25);
  const QuadMesh free = refined(divided_square(1e-3, 1e-3), options);
  for (int chord = 0; chord < 3; ++chord) options.counts.push_back({chord, 2});
  EXPECT_GT(free.num_elems(), 8);
  EXPECT_EQ(refined(divided_square(1e-3, 1e-3), options).num_elems(), 8);
}

TEST(LengthLimits, layers_along_walls_stay) {
  RefineOptions options = with_size(0.25);
  layers::WallSpec wall;
  wall.names = {"bottom"};
  wall.first = 1e-4;
  wall.layers = 5;
  SeparatrixGraph square = hand_made::unit_square();
  square.face.curve_names[0] = "bottom";
  options.walls = {wall};
  const QuadMesh mesh = refined(square, options);
  EXPECT_GT(greatest_ratio(mesh), 1000);
  EXPECT_EQ(vertices_below(mesh).size(), 5u);
}

}  // namespace
}  // namespace quadrille::refine
