#include "block/split_chord.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "block/extract_blocks.hpp"
#include "block/make_blocks.hpp"
#include "block_samples.hpp"
#include "check/check.hpp"

namespace quadrille::block {
namespace {

std::string faults(const BlockLayout& layout) {
  std::string all;
  for (const check::Violation& v : check::check_block_layout(layout, check::CheckDepth::full))
    all += v.rule + ": " + v.text + "\n";
  return all;
}

int arc_of(const BlockLayout& layout, int chord) {
  return static_cast<int>(std::find(layout.arc_chord.begin(), layout.arc_chord.end(), chord) -
                          layout.arc_chord.begin());
}

BlockLayout cut(const SeparatrixGraph& graph, int chord) {
  graph::Subdivision subdivision = subdivision_into_blocks(graph);
  EXPECT_TRUE(split_chord(subdivision, arc_of(blocks_of(subdivision), chord),
                          std::vector<bool>(subdivision.num_faces(), true)));
  BlockLayout layout = blocks_of(subdivision);
  store_measures(measure_blocks(layout), layout);
  return layout;
}

TEST(SplitChord, StaysConforming) {
  EXPECT_EQ(cut(hand_made::unit_square(), 1).num_blocks(), 2);
  EXPECT_EQ(cut(hand_made::l_shape(), 0).num_blocks(), 5);
  EXPECT_EQ(cut(hand_made::cut_annulus(4), 0).num_blocks(), 5) << "an open chord, across one sector";
  EXPECT_EQ(cut(hand_made::cut_annulus(4), 1).num_blocks(), 8) << "the closed chord, all round";
  for (const BlockLayout& layout :
       {cut(hand_made::unit_square(), 0), cut(hand_made::unit_square(), 1), cut(hand_made::l_shape(), 0),
        cut(hand_made::l_shape(), 1), cut(hand_made::cut_annulus(4), 0), cut(hand_made::cut_annulus(4), 1),
        cut(hand_made::s_bend(), 0), cut(hand_made::elbow(), 0)})
    EXPECT_EQ(faults(layout), "");
}

TEST(SplitChord, HalvesASquare) {
  const BlockLayout layout = cut(hand_made::unit_square(), 0);
  ASSERT_EQ(layout.num_blocks(), 2);
  for (const BlockMeasure& m : measure_blocks(layout)) EXPECT_NEAR(m.area, 0.5, 1e-12);
  EXPECT_NEAR(layout.nodes[4].position.x, 0.5, 1e-12);
  EXPECT_NEAR(layout.nodes[5].position.x, 0.5, 1e-12);
}

TEST(SplitChord, CutOfASoundBlockIsALineOfItsMap) {
  const BlockLayout layout = cut(hand_made::cut_annulus(4), 1);
  for (const BlockMeasure& m : measure_blocks(layout)) EXPECT_NEAR(m.scaled_jacobian, 1, 1e-6);
  for (const Nurbs& spline : std::vector<Nurbs>(layout.splines.end() - 4, layout.splines.end()))
    for (int i = 0; i <= 8; ++i) EXPECT_NEAR(norm(curve::point(spline, spline.end() * i / 8)), 0.75, 1e-8);
}

TEST(SplitChord, LeavesPrescribedLengthsAlone) {
  SeparatrixGraph square = hand_made::unit_square();
  square.arcs[2].length = 3;
  graph::Subdivision subdivision(square);
  const std::vector<bool> sound{true};
  EXPECT_FALSE(split_chord(subdivision, 0, sound));
  EXPECT_EQ(subdivision.num_faces(), 1);
  EXPECT_TRUE(split_chord(subdivision, 1, sound));
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
  EXPECT_EQ(faults(mended.layout), "");
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

}  // namespace
}  // namespace quadrille::block
