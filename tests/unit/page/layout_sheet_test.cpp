#include <gtest/gtest.h>

#include "../region_layout_samples.hpp"
#include "sheet_samples.hpp"

namespace quadrille::page {
namespace {

TEST(LayoutSheet, ArcsOfLinesHaveTheirLineAndOthersTheirNumber) {
  SeparatrixGraph graph = samples::separatrix_graph();
  const Sheet sheet = stage_sheet(graph, frame);
  EXPECT_EQ(sheet.caption, "1 separatrices, 6 nodes");
  expect_contains(layer_of(sheet, "lines"), R"("names":["separatrix 0 from node 4 to node 5, cut"])");
  graph.lines.clear();
  expect_contains(layer_of(stage_sheet(graph, frame), "lines"),
                  R"("names":["arc 6"],"colours":")" + packed(std::vector<std::int32_t>{-1}));
}

TEST(LayoutSheet, InterfacesAreNoLines) {
  EXPECT_EQ(count(layer_of(stage_sheet(samples::two_regions_graph(), frame), "lines"), "arc "), 0);
}

TEST(LayoutSheet, BlocksAreChainsOfTheirFourSides) {
  BlockLayout layout = samples::block_layout();
  layout.block_scaled_jacobian = {0.75, 0.5};
  const Sheet sheet = stage_sheet(layout, frame);
  EXPECT_EQ(sheet.caption, "2 blocks, 3 chords");
  EXPECT_EQ(sheet.facts.back().value, "0.5");
  const std::string blocks = layer_of(sheet, "blocks");
  expect_contains(blocks, R"("names":["block-0","block-1"])");
  expect_contains(blocks, member("colours", {0, 1}));
  expect_contains(blocks, member("offsets", {0, 13, 26}));
  expect_contains(layer_of(sheet, "arcs"),
                  R"("names":["chord 0","chord 1","chord 2","chord 1","chord 0","chord 2","chord 2"])");
}

TEST(LayoutSheet, ColoursAreThoseOfRegionsIfThereAreSeveral) {
  BlockLayout layout = samples::two_regions_layout();
  layout.block_region = {1, 0};
  expect_contains(layer_of(stage_sheet(layout, frame), "blocks"), member("colours", {1, 0}));
}

TEST(LayoutSheet, WithoutMeasuresThereAreNone) {
  BlockLayout layout = samples::block_layout();
  layout.block_scaled_jacobian.clear();
  layout.arc_chord.clear();
  const Sheet sheet = stage_sheet(layout, frame);
  EXPECT_EQ(count(layer_of(sheet, "blocks"), "scaled Jacobian"), 0);
  EXPECT_EQ(count(layer_of(sheet, "arcs"), "chord "), 0);
}

}  // namespace
}  // namespace quadrille::page
