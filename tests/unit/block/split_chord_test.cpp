#include "block/split_chord.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "block/extract_blocks.hpp"
#include "block/make_blocks.hpp"
#include "block_samples.hpp"

namespace quadrille::block {
namespace {

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

}  // namespace
}  // namespace quadrille::block
