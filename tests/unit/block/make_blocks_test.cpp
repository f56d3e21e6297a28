#include "block/make_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/snail.hpp"
#include "block/extract_blocks.hpp"
#include "block_samples.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::block {
namespace {

/// Of a line from (0, 0) to (10, 0), walked backwards, and another one, at their middles.
std::optional<double> difference(Vec2 from, Vec2 to) {
  CadFace face;
  face.curves = {curve::segment({10, 0}, {0, 0}), curve::segment(from, to)};
  const std::vector<Nurbs> none;
  const curve::CurveTable table(face, none);
  const curve::Chain a(table, {{0, 0, 10}}), b(table, {{1, face.curves[1].begin(), face.curves[1].end()}});
  return opposite_point_offset({&a, true}, {&b, false}, 0.5);
}

TEST(OppositePoints, IsZeroWhereMiddlesFaceEachOther) {
  ASSERT_TRUE(difference({2, 1}, {8, 1}));
  EXPECT_NEAR(*difference({2, 1}, {8, 1}), 0, 1e-15);
}

TEST(OppositePoints, FollowsAShift) {
  // 10 (1/2 - d/2) = 2 + 10 (1/2 + d/2)
  ASSERT_TRUE(difference({2, 1}, {12, 1}));
  EXPECT_NEAR(*difference({2, 1}, {12, 1}), -0.2, 1e-12);
  EXPECT_NEAR(*difference({-2, 1}, {8, 1}), 0.2, 1e-12);
}

TEST(OppositePoints, FindsNothingWhereTheEndsDoNotReach) { EXPECT_FALSE(difference({11, 1}, {21, 1})); }

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
    EXPECT_EQ(block_samples::faults(layout), "");
}

TEST(SplitChord, LeavesTheMeasuresOfBlocksThatItDoesNotCut) {
  graph::Subdivision subdivision = subdivision_into_blocks(hand_made::l_shape());
  Blocks before{blocks_of(subdivision), {}};
  before.measures = measure_blocks(before.layout);
  ASSERT_EQ(before.measures.size(), 3u);
  for (BlockMeasure& m : before.measures) m.area = -1;
  ASSERT_TRUE(split_chord(subdivision, arc_of(before.layout, 0), {true, true, true}));
  const BlockLayout after = blocks_of(subdivision);
  const std::vector<BlockMeasure> taken = measure_blocks(after, nullptr, before), anew = measure_blocks(after);
  ASSERT_EQ(taken.size(), 5u);
  int num_taken = 0;
  for (std::size_t b = 0; b < taken.size(); ++b) {
    const std::array<HalfEdge, 4>& sides = before.layout.block2arcs[std::min<std::size_t>(b, 2)];
    const bool is_cut = before.layout.arc_chord[sides[0].arc] == 0 || before.layout.arc_chord[sides[1].arc] == 0;
    EXPECT_EQ(taken[b].area, b < 3 && !is_cut ? -1 : anew[b].area);
    num_taken += taken[b].area < 0;
  }
  EXPECT_EQ(num_taken, 1);
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

TEST(MakeBlocks, WarnsOnceOfAllBlocksAndNamesTheWorst) {
  Report report;
  const Blocks blocks = make_blocks(block_samples::two_darts(), report);
  ASSERT_EQ(blocks.layout.num_blocks(), 2);
  ASSERT_EQ(report.warnings().size(), 1u);
  const std::string& text = report.warnings()[0].message;
  const double first = blocks.measures[0].scaled_jacobian, second = blocks.measures[1].scaled_jacobian;
  EXPECT_EQ(text.find(first <= second ? "block_0 cannot be proved" : "block_1 cannot be proved"), 0u) << text;
  EXPECT_NE(text.find(" (2 blocks; this one is the worst)"), std::string::npos) << text;
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
