#include <gtest/gtest.h>

#include "../support/block_sides.hpp"
#include "square_samples.hpp"

namespace quadrille::draw {
namespace {

TEST(DrawBlockLayout, BlocksShowNumbersInTheirMiddle) {
  const SeparatrixGraph graph = halved_square();
  BlockLayout layout;
  layout.face = graph.face;
  layout.splines = graph.splines;
  layout.nodes = graph.nodes;
  layout.arcs = graph.arcs;
  layout.block2nodes = {{0, 1, 4, 5}, {5, 4, 2, 3}};
  layout.block2arcs = {block_sides({0, 1, -7, 5}), block_sides({6, 2, 3, 4})};
  layout.arc_chord = {0, 1, 2, 0, 2, 1, 0};
  layout.block_names = {"inlet block", ""};
  DrawOptions options;
  options.width = 1072;  // 1000 pixels a unit
  const std::string svg = draw_stage(layout, options);
  expect_sound(svg);
  EXPECT_EQ(count(svg, "id=\"block-"), 2);
  EXPECT_EQ(count(svg, "<title>block 0: inlet block<"), 1);
  EXPECT_EQ(count(svg, "x=\"500\" y=\"754\">0</text>"), 1) << svg;
  EXPECT_EQ(count(svg, "x=\"500\" y=\"254\">1</text>"), 1);
  EXPECT_EQ(count(svg, "3 chords"), 1);
  EXPECT_EQ(count(svg, "class=\"worst\""), 0) << "not known";

  layout.block_scaled_jacobian = {0.25, 0.75};
  layout.nodes[4].valence = 3;
  layout.nodes[4].kind = NodeKind::boundary;
  const std::string measured = draw_stage(layout, options);
  expect_sound(measured);
  EXPECT_EQ(count(measured, "<title>block 0, scaled Jacobian 0.25<"), 1);
  EXPECT_EQ(count(measured, "class=\"worst\""), 2) << "block 0 and the legend";
  EXPECT_EQ(count(measured, "<title>irregular node on the boundary of valence 3 at (1, 0.5)<"), 1) << measured;
  EXPECT_EQ(count(measured, "on the boundary, valence 3<"), 1);
  EXPECT_EQ(count(measured, "1 irregular node"), 1);

  layout.block_scaled_jacobian = {0.25, 0.25};
  EXPECT_EQ(count(draw_stage(layout, options), "class=\"worst\""), 2) << "one mark for the worst";
  layout.block_scaled_jacobian = {1, 0.5};
  EXPECT_EQ(count(draw_stage(layout, options), "class=\"worst\""), 0) << "nothing to complain of";
}

}  // namespace
}  // namespace quadrille::draw
