#include "block/make_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/snail.hpp"
#include "block_samples.hpp"

namespace quadrille::block {
namespace {

long long added_blocks(const Report& report) {
  for (const auto& [key, value] : report.entries())
    if (key == "blocks_added_to_mend") return std::get<long long>(value);
  return -1;
}

TEST(MakeBlocks, LeavesSoundLayoutsAlone) {
  for (const SeparatrixGraph& graph : {hand_made::l_shape(), hand_made::s_bend(), hand_made::elbow()}) {
    Report report;
    const BlockLayout plain = extract_blocks(graph), made = make_blocks(graph, report).layout;
    EXPECT_EQ(made.block2arcs, plain.block2arcs);
    EXPECT_EQ(made.splines.size(), plain.splines.size());
    EXPECT_TRUE(report.warnings().empty());
  }
}

TEST(MakeBlocks, CutsAStripWhoseMapFolds) {
  ASSERT_EQ(measure_blocks(extract_blocks(block_samples::near_tangent_strip()))[0].divisions, 0);
  Report report;
  const Blocks mended = make_blocks(block_samples::near_tangent_strip(), report);
  EXPECT_GE(mended.layout.num_blocks(), 2);
  for (const BlockMeasure& m : mended.measures) EXPECT_GT(m.divisions, 0);
  EXPECT_EQ(block_samples::faults(mended.layout), "");
  EXPECT_TRUE(report.warnings().empty());
}

TEST(MakeBlocks, CutsABlockAroundANoseAtTheNose) {
  ASSERT_EQ(measure_blocks(extract_blocks(block_samples::nose()))[0].divisions, 0);
  Report report;
  const Blocks mended = make_blocks(block_samples::nose(), report);
  ASSERT_EQ(mended.layout.num_blocks(), 2);
  for (const BlockMeasure& m : mended.measures) EXPECT_GT(m.divisions, 0);
  const std::vector<GraphNode>& nodes = mended.layout.nodes;
  EXPECT_TRUE(std::any_of(nodes.begin(), nodes.end(), [](const GraphNode& n) { return norm(n.position) < 1e-9; }));
  EXPECT_TRUE(report.warnings().empty());
}

TEST(MakeBlocks, CutsAValidStripOfPoorShape) {
  const SeparatrixGraph graph = block_samples::near_tangent_strip(false, 0.003);
  const BlockMeasure before = measure_blocks(extract_blocks(graph))[0];
  EXPECT_EQ(before.divisions, 1);
  EXPECT_LT(before.map_scaled_jacobian, 0.1);
  Report report;
  const Blocks mended = make_blocks(graph, report);
  EXPECT_EQ(mended.layout.num_blocks(), 2);
  for (const BlockMeasure& m : mended.measures) EXPECT_GT(m.map_scaled_jacobian, 0.5);
}

TEST(MakeBlocks, CutsAMirroredStripInTheMirroredPlaces) {
  Report report;
  const BlockLayout a = make_blocks(block_samples::near_tangent_strip(), report).layout;
  const BlockLayout b = make_blocks(block_samples::near_tangent_strip(true), report).layout;
  ASSERT_EQ(a.num_blocks(), b.num_blocks());
  for (const GraphNode& node : a.nodes) {
    double nearest = 1;
    for (const GraphNode& other : b.nodes)
      nearest = std::min(nearest, distance(other.position, {node.position.x, -node.position.y}));
    EXPECT_LT(nearest, 1e-10);
  }
}

TEST(MakeBlocks, WarnsOfWhatNoCutMakesValid) {
  Report report;
  const Blocks blocks = make_blocks(block_samples::dart(), report);
  EXPECT_EQ(blocks.layout.num_blocks(), 1);
  ASSERT_EQ(report.warnings().size(), 1u);
  EXPECT_EQ(report.warnings()[0].code, "W-BLK-001");
  EXPECT_NE(report.warnings()[0].message.find("block_0 cannot be proved valid near ("), std::string::npos)
      << report.warnings()[0].message;
}

TEST(MakeBlocks, TheReportCountsTheBlocksThatWereAdded) {
  Report untouched, mended, hopeless;
  make_blocks(hand_made::l_shape(), untouched);
  EXPECT_EQ(added_blocks(untouched), 0);
  const Blocks blocks = make_blocks(block_samples::near_tangent_strip(), mended);
  EXPECT_EQ(added_blocks(mended), blocks.layout.num_blocks() - 1);
  EXPECT_GT(added_blocks(mended), 0);
  make_blocks(block_samples::dart(), hopeless);
  EXPECT_EQ(added_blocks(hopeless), 0) << "cuts in vain are undone";
}

TEST(MakeBlocks, MeasuresAreThoseOfTheLayout) {
  Report report;
  const Blocks blocks = make_blocks(block_samples::near_tangent_strip(), report);
  const std::vector<BlockMeasure> again = measure_blocks(blocks.layout);
  ASSERT_EQ(blocks.measures.size(), again.size());
  for (std::size_t b = 0; b < again.size(); ++b) {
    EXPECT_EQ(blocks.measures[b].area, again[b].area);
    EXPECT_EQ(blocks.measures[b].scaled_jacobian, again[b].scaled_jacobian);
    EXPECT_EQ(blocks.layout.block_scaled_jacobian[b], again[b].scaled_jacobian);
  }
}

TEST(MakeBlocks, TheWarningGivesThePlaceInTheModelsCoordinates) {
  SeparatrixGraph dart = block_samples::dart();
  dart.face.origin = {1000, 0};
  Report report;
  make_blocks(dart, report);
  ASSERT_EQ(report.warnings().size(), 1u);
  EXPECT_NE(report.warnings()[0].message.find("near (1000"), std::string::npos) << report.warnings()[0].message;
}

TEST(MakeBlocks, TheLapsOfASpiralAreSoundBlocks) {
  Report report;
  graph::CandidateLayout snail = snail::layout();
  const Blocks blocks = make_blocks(graph::separatrix_graph(std::move(snail)), report);
  EXPECT_EQ(blocks.layout.num_blocks(), 5);
  EXPECT_TRUE(report.warnings().empty());
  for (const BlockMeasure& m : blocks.measures) EXPECT_GT(m.map_scaled_jacobian, 0.5);
}

}  // namespace
}  // namespace quadrille::block
