#include "block/report_layout.hpp"

#include <gtest/gtest.h>

#include "block_samples.hpp"

namespace quadrille::block {
namespace {

SmallestBlock smallest_of(const SeparatrixGraph& graph) {
  const BlockLayout layout = extract_blocks(graph);
  return smallest_block(layout, measure_blocks(layout));
}

TEST(SmallestBlock, AlongTheBoundaryIsForcedByTheCurvesOnBothSides) {
  const SmallestBlock s = smallest_of(hand_made::quarter_annulus());
  EXPECT_EQ(s.block, 0);
  EXPECT_NEAR(distance(s.position, {1.5, 0}), 0, 1e-12);
  EXPECT_EQ(s.between[0].curve, 3);
  EXPECT_EQ(s.between[1].curve, 1);
  EXPECT_FALSE(s.between[0].is_corner || s.between[1].is_corner);
}

TEST(SmallestBlock, ReflexCornerForcesItsLines) {
  const SmallestBlock s = smallest_of(hand_made::l_shape());
  EXPECT_EQ(s.block, 0) << "the first of equal ones";
  EXPECT_EQ(s.between[0].curve, 5);
  EXPECT_FALSE(s.between[0].is_corner);
  EXPECT_EQ(s.between[1].curve, 3);
  EXPECT_TRUE(s.between[1].is_corner);
  EXPECT_EQ(s.between[1].position, (Vec2{1, 1}));
}

TEST(SmallestBlock, FeaturesHaveNames) {
  CadFace face = hand_made::cut_annulus(4).face;
  face.curve_names = {"rim", ""};
  EXPECT_EQ(name_of(face, {0, false, {}}), "curve 0 'rim'");
  EXPECT_EQ(name_of(face, {1, false, {}}), "curve 1 (hole 1)");
  CadFace square = hand_made::unit_square().face;
  square.curve_names = {"curve_0", "curve_1", "", "lid"};
  square.unnamed_curves = {0, 1};
  EXPECT_EQ(name_of(square, {0, true, {}}), "the corner of curves 3 'lid' and 0");
}

TEST(SmallestBlock, OneLineForPeople) {
  BlockLayout layout = extract_blocks(hand_made::cut_annulus(4));
  layout.face.curve_names = {"rim", "hole"};
  layout.face.origin = {10, 20};
  const std::string words = summarise_layout(layout, measure_blocks(layout));
  EXPECT_EQ(words.rfind("4 blocks, least scaled Jacobian 1.00 (block ", 0), 0u) << words;
  EXPECT_NE(words.find("a side of 0.5 near (10"), std::string::npos) << words;
  EXPECT_NE(words.find("between curve 0 'rim' and curve 1 'hole' (hole 1)"), std::string::npos) << words;
}

}  // namespace
}  // namespace quadrille::block
