#include "block/extract_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "../hand_made.hpp"
#include "../support/block_sides.hpp"
#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "block_samples.hpp"
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

using Kind = NameRule::Kind;
using Names = std::vector<std::string>;

NameRule at(double x, double y, const std::string& name = "new") {
  return {Kind::position, "", -1, {x, y}, name, "n: entry 0"};
}

NameRule numbered(int number, const std::string& name) { return {Kind::number, "", number, {}, name, "n: number"}; }

Names named(BlockLayout layout, const std::vector<NameRule>& rules) {
  name_blocks(layout, rules);
  return layout.block_names;
}

std::string refusal(const BlockLayout& layout, const std::vector<NameRule>& rules) {
  return message_of<FormatError>([&] { named(layout, rules); });
}

/// The number of the only block that `rule` names; -1 where it is refused.
int block_at(const BlockLayout& layout, const NameRule& rule) {
  if (!refusal(layout, {rule}).empty()) return -1;
  const Names names = named(layout, {rule});
  EXPECT_EQ(std::count(names.begin(), names.end(), "new"), 1);
  return static_cast<int>(std::find(names.begin(), names.end(), "new") - names.begin());
}

TEST(NameBlocks, WithoutNamesNothingChanges) {
  const BlockLayout layout = extract_blocks(hand_made::l_shape());
  EXPECT_EQ(named(layout, {}), layout.block_names);
}

TEST(NameBlocks, TheNameOfTheFaceIsThatOfAllBlocks) {
  BlockLayout layout = extract_blocks(hand_made::l_shape());
  layout.face.name = "fluid";
  EXPECT_EQ(named(layout, {}), Names(layout.num_blocks(), "fluid"));
  Names expected(layout.num_blocks(), "fluid");
  expected[1] = "solid";
  EXPECT_EQ(named(layout, {numbered(1, "solid")}), expected);
}

TEST(NameBlocks, ByNumberAndTheRest) {
  const BlockLayout layout = extract_blocks(hand_made::l_shape());
  Names expected(layout.num_blocks(), "rest");
  expected[0] = "first";
  EXPECT_EQ(named(layout, {{Kind::rest, "", -1, {}, "rest", "n"}, numbered(0, "first")}), expected);
  EXPECT_EQ(refusal(layout, {numbered(3, "x")}), "n: number: no block has this number; blocks are numbered 0 to 2");
  EXPECT_NE(refusal(layout, {numbered(-1, "x")}), "");
}

TEST(NameBlocks, ByAPointInsideCurvedBlocks) {
  const BlockLayout layout = extract_blocks(hand_made::cut_annulus(4));
  ASSERT_EQ(layout.num_blocks(), 4);
  for (int b = 0; b < 4; ++b) {
    Vec2 middle;
    for (const int node : layout.block2nodes[b]) middle += 0.25 * layout.nodes[node].position;
    for (const double radius : {0.5001, 0.75, 0.9999})
      for (const double turn : {-0.7, 0.0, 0.7}) {
        const Vec2 x = radius * unit(angle_of(middle) + turn);
        EXPECT_EQ(block_at(layout, at(x.x, x.y)), b) << radius << " " << turn;
      }
  }
  EXPECT_EQ(refusal(layout, {at(0.25, 0.125)}), "n: entry 0: (0.25, 0.125) lies in no block");
  EXPECT_EQ(block_at(layout, at(0, 0)), -1) << "in the hole";
  EXPECT_EQ(block_at(layout, at(2, 0.1)), -1) << "outside";
}

TEST(NameBlocks, PositionsHoldTheOriginOfTheFace) {
  BlockLayout layout = extract_blocks(hand_made::unit_square());
  layout.face.origin = {100, 200};
  EXPECT_EQ(block_at(layout, at(100.5, 200.5)), 0);
  EXPECT_EQ(block_at(layout, at(0.5, 0.5)), -1);
}

TEST(NameBlocks, APointOnASideIsRefusedWithTheBlocksBesideIt) {
  const BlockLayout layout = extract_blocks(hand_made::cut_annulus(4));
  for (const auto& arc : layout.arcs) {
    if (arc.is_boundary) continue;
    const Vec2 x = 0.5 * (layout.nodes[arc.from].position + layout.nodes[arc.to].position);
    const std::string message = refusal(layout, {at(x.x, x.y)});
    EXPECT_NE(message.find("lies on a side of block "), std::string::npos) << message;
    EXPECT_NE(message.find(" and of block "), std::string::npos) << message;
  }
}

TEST(NameBlocks, TwoRulesForOneBlockAreRefused) {
  const BlockLayout layout = extract_blocks(hand_made::unit_square());
  EXPECT_EQ(refusal(layout, {numbered(0, "x"), at(0.5, 0.5, "y")}),
            "n: entry 0 names block 0, as n: number does: \"y\" or \"x\"?");
}

}  // namespace
}  // namespace quadrille::block
