#include "refine/chosen_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../hand_made.hpp"
#include "base/error.hpp"
#include "block/extract_blocks.hpp"
#include "refine/refine.hpp"

namespace quadrille::refine {
namespace {

BlockLayout layout_of(const SeparatrixGraph& graph) {
  Report report;
  return block::extract_blocks(graph, report);
}

QuadMesh refined(const BlockLayout& layout, const RefineOptions& options) {
  Report report;
  return refine(layout, options, report);
}

int elems_in(const QuadMesh& mesh, int block) {
  return static_cast<int>(std::count(mesh.elem_block.begin(), mesh.elem_block.end(), block));
}

TEST(ChosenBlocks, AreNamedByNumberOrName) {
  const std::vector<std::string> names{"inlet", "block_1", "0", "outlet"};
  EXPECT_EQ(parse_blocks("3", names), (std::vector<int>{3}));
  EXPECT_EQ(parse_blocks("outlet,1,inlet,3", names), (std::vector<int>{0, 1, 3}));
  EXPECT_EQ(parse_blocks("0", names), (std::vector<int>{2})) << "a name goes before a number";
  EXPECT_EQ(parse_blocks("b,1", {"a", "a", "b", "b"}), (std::vector<int>{1, 2, 3})) << "blocks may share a name";
  for (const char* wrong : {"4", "-1", "", "1,", "1,,2", "wall", "1x"})
    EXPECT_THROW(parse_blocks(wrong, names), UsageError);
}

TEST(ChosenBlocks, OtherChordsGetOneElement) {
  // L of three unit squares: the corner block shares a chord with each of the others, which have one of their own.
  const BlockLayout layout = layout_of(hand_made::l_shape());
  RefineOptions options{0.25, 2, 5e-7};
  ASSERT_EQ(refined(layout, options).num_elems(), 48);
  std::vector<int> totals;
  for (int block = 0; block < 3; ++block) {
    options.blocks = {block};
    const QuadMesh mesh = refined(layout, options);
    EXPECT_EQ(elems_in(mesh, block), 16);
    EXPECT_TRUE(mesh.is_valid);
    totals.push_back(mesh.num_elems());
  }
  std::sort(totals.begin(), totals.end());
  EXPECT_EQ(totals, (std::vector<int>{16 + 4 + 1, 16 + 4 + 1, 16 + 4 + 4}));
}

TEST(ChosenBlocks, ACountThatWasAskedForStays) {
  const BlockLayout layout = layout_of(hand_made::l_shape());
  RefineOptions options{0.25, 1, 5e-7};
  options.blocks = {0};
  const int before = refined(layout, options).num_elems();
  const sizing::MeasuredLayout measured(layout);
  const std::vector<sizing::ChordCount> coarse = coarse_counts(measured, {0}, {});
  ASSERT_FALSE(coarse.empty());
  EXPECT_TRUE(coarse_counts(measured, {0}, {{coarse[0].chord, 3}}).size() == coarse.size() - 1);
  options.counts = {{coarse[0].chord, 3}};
  EXPECT_GT(refined(layout, options).num_elems(), before);
}

TEST(ChosenBlocks, ToleranceAndTopologyAskForMore) {
  // A ring cut once: the chord along the ring needs three elements, and more for the circles.
  const BlockLayout layout = layout_of(hand_made::cut_annulus(4));
  RefineOptions options{0.1, 2, 1e-4};
  options.blocks = {0};
  const QuadMesh mesh = refined(layout, options);
  const int across = elems_in(mesh, 0) / elems_in(mesh, 1);
  EXPECT_GT(across, 1) << "block 1 has fewer";
  EXPECT_GT(elems_in(mesh, 1), 5) << "but not one, since its circles need more";
  EXPECT_TRUE(mesh.is_valid);
}

TEST(ChosenBlocks, CountsRiseWhereElementsAreNotProved) {
  const BlockLayout layout = layout_of(hand_made::l_shape());
  const sizing::MeasuredLayout measured(layout);
  QuadMesh mesh = refined(layout, {1, 1, 5e-7});
  std::vector<sizing::ChordCount> coarse = coarse_counts(measured, {0}, {});
  EXPECT_FALSE(raise_counts(measured, mesh, coarse)) << "all elements are proved";
  for (double& bound : mesh.elem_jacobian_bound) bound = -1;
  EXPECT_TRUE(raise_counts(measured, mesh, coarse));
  for (const sizing::ChordCount& c : coarse) EXPECT_EQ(c.count, 2);
  int rounds = 0;
  while (raise_counts(measured, mesh, coarse)) ++rounds;
  EXPECT_LT(rounds, 20) << "it ends";
}

TEST(DoubleCounts, OfChordsThroughBlocksWithoutAProofOnly) {
  const BlockLayout layout = layout_of(hand_made::l_shape());
  const sizing::MeasuredLayout measured(layout);
  QuadMesh mesh;
  mesh.elem_block = {0, 1, 2};
  mesh.elem_jacobian_bound = {-1, 1, 1};
  sizing::ArcDivisions divisions(measured.num_arcs());
  for (sizing::ArcDivision& division : divisions) division.ends = {0, 0.3, 0.6, 1};
  const int first = measured.chord_of(layout.block2arcs[0][0].arc),
            second = measured.chord_of(layout.block2arcs[0][1].arc);
  std::vector<sizing::ChordCount> counts{{first, 1}};
  EXPECT_TRUE(double_counts(measured, mesh, divisions, {}, counts));
  ASSERT_EQ(counts.size(), 2u);
  for (const sizing::ChordCount& c : counts) {
    EXPECT_TRUE(c.chord == first || c.chord == second);
    EXPECT_EQ(c.count, 6);
  }
  counts.clear();
  EXPECT_TRUE(double_counts(measured, mesh, divisions, {{first, 3}}, counts));
  ASSERT_EQ(counts.size(), 1u);
  EXPECT_EQ(counts.front().chord, second);
  EXPECT_FALSE(double_counts(measured, mesh, divisions, {{first, 3}, {second, 3}}, counts));
}

}  // namespace
}  // namespace quadrille::refine
