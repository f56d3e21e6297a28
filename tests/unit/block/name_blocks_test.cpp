#include "block/name_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "block_samples.hpp"

namespace quadrille::block {
namespace {

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
