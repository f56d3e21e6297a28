#include "refine/shortest_kept_edge.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../hand_made.hpp"
#include "block/extract_blocks.hpp"

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

}  // namespace
}  // namespace quadrille::refine
