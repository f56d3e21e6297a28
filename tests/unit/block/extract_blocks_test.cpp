#include "block/extract_blocks.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "../hand_made.hpp"
#include "../support/block_sides.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"
#include "mesh/chords.hpp"

namespace quadrille::block {
namespace {

BlockLayout extracted(const SeparatrixGraph& graph) {
  Report report;
  return extract_blocks(graph, report);
}

/// Sides follow each other around every block; each direction of an inner arc bounds one block, of a boundary arc the
/// first only.
void expect_consistent(const BlockLayout& layout) {
  std::multiset<HalfEdge> sides;
  for (int b = 0; b < layout.num_blocks(); ++b)
    for (int k = 0; k < 4; ++k) {
      const HalfEdge side = layout.block2arcs[b][k];
      sides.insert(side);
      EXPECT_EQ(start_of(layout.arcs, side), layout.block2nodes[b][k]);
      EXPECT_EQ(end_of(layout.arcs, side), layout.block2nodes[b][(k + 1) % 4]);
    }
  for (int a = 0; a < static_cast<int>(layout.arcs.size()); ++a) {
    EXPECT_EQ(sides.count({a}), 1u);
    EXPECT_EQ(sides.count({a, true}), layout.arcs[a].is_boundary ? 0u : 1u);
  }
}

TEST(ExtractBlocks, OneBlockPerFace) {
  const BlockLayout square = extracted(hand_made::unit_square());
  EXPECT_EQ(square.num_blocks(), 1);
  EXPECT_EQ(square.block2arcs[0], block_sides({0, 1, 2, 3}));
  EXPECT_EQ(square.block_names[0], "block_0");
  EXPECT_NEAR(square.block_jacobian_bound[0], 0.25, 1e-9);
  for (const auto& [graph, count] : {std::pair{hand_made::l_shape(), 3}, std::pair{hand_made::cut_annulus(4), 4},
                                     std::pair{hand_made::elbow(), 1}}) {
    const BlockLayout layout = extracted(graph);
    EXPECT_EQ(layout.num_blocks(), count);
    expect_consistent(layout);
  }
}

TEST(ExtractBlocks, ChordsRunThroughOppositeSides) {
  EXPECT_EQ(extracted(hand_made::unit_square()).arc_chord, (std::vector<int>{0, 1, 0, 1}));
  const BlockLayout annulus = extracted(hand_made::cut_annulus(4));
  // Arcs come as outer, inner, cut; all cuts are one closed chord, each sector is one.
  EXPECT_EQ(annulus.arc_chord, (std::vector<int>{0, 0, 1, 2, 2, 1, 3, 3, 1, 4, 4, 1}));
}

TEST(ExtractBlocks, BlockMayTouchItself) {
  const BlockLayout layout = extracted(hand_made::cut_annulus(1));
  ASSERT_EQ(layout.num_blocks(), 1);
  expect_consistent(layout);
  EXPECT_EQ(layout.arc_chord, (std::vector<int>{0, 0, 1}));
}

TEST(ExtractBlocks, FoldedBlockHasNoPositiveBound) {
  const std::vector<Nurbs> loop{curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, {0.1, 0.1}),
                                curve::segment({0.1, 0.1}, {0, 1}), curve::segment({0, 1}, {0, 0})};
  const BlockLayout layout =
      extracted(hand_made::one_block(hand_made::face({loop}, std::sqrt(2.0)), {{0}, {1}, {2}, {3}}));
  EXPECT_LE(layout.block_jacobian_bound[0], 0);
}

std::string refusal(const SeparatrixGraph& graph) {
  return message_of<ComputeError>([&] { extracted(graph); });
}

TEST(ExtractBlocks, FaceThatIsNotFourSidedIsNamedWithItsPlace) {
  SeparatrixGraph graph = hand_made::unit_square();
  graph.face.origin = {100, 200};
  hand_made::add_cut(graph, 0, 2);  // two triangles
  EXPECT_NE(refusal(graph).find("2 of 2 faces"), std::string::npos);
  EXPECT_NE(refusal(graph).find("(100.667, 200.333)"), std::string::npos);
}

TEST(ExtractBlocks, UncutHoleIsNamed) {
  SeparatrixGraph graph = hand_made::cut_annulus(4);
  std::erase_if(graph.arcs, [](const GraphArc& arc) { return !arc.is_boundary; });
  EXPECT_NE(refusal(graph).find("four corners"), std::string::npos);
}

TEST(ExtractBlocks, TJunctionsAreRefusedWithTheirPlace) {
  SeparatrixGraph graph = hand_made::l_shape();
  graph.t_junctions = {3};
  EXPECT_NE(refusal(graph).find("(1, 1)"), std::string::npos);
}

}  // namespace
}  // namespace quadrille::block
