// Pictures of graphs, blocks and meshes of several regions.

#include <gtest/gtest.h>

#include <set>

#include "../support/refined.hpp"
#include "../support/region_graphs.hpp"
#include "../support/texts.hpp"
#include "draw/draw.hpp"
#include "draw/palette.hpp"

namespace quadrille::draw {
namespace {

SeparatrixGraph disc() {
  SeparatrixGraph graph = region_graphs::disc_in_square();
  graph.face.region_names = {"air", "steel"};
  graph.face.curve_names = {"outside", "outside", "outside", "outside", "skin", "skin"};
  return graph;
}

BlockLayout layout_of(const SeparatrixGraph& graph) {
  Report report;
  return block::extract_blocks(graph, report);
}

TEST(DrawRegions, EachInterfaceIsDrawnOnceInItsOwnStroke) {
  for (const std::string& svg :
       {draw_stage(disc(), {}), draw_stage(layout_of(disc()), {}), draw_stage(refined(disc(), {.size = 0.5}), {})}) {
    EXPECT_EQ(count(svg, "interface, curves 4 and 5: skin"), 1);
    EXPECT_EQ(count(svg, "boundary curve "), 4);
    EXPECT_EQ(count(svg, ">skin</text>"), 1) << "one label for both sides";
    EXPECT_EQ(count(svg, ">interface of two regions</text>"), 1) << "in the legend";
    EXPECT_GE(count(svg, ">steel</text>"), 1);
    EXPECT_EQ(count(svg, ", 2 regions"), 1) << "in the caption";
    EXPECT_EQ(count(svg, "arc 1, chord"), 0) << "not as a line between blocks too";
  }
}

TEST(DrawRegions, RegionsHaveTints) {
  const std::string graph = draw_stage(disc(), {});
  for (const int region : {0, 1}) EXPECT_GE(count(graph, region_colour(region)), 2) << "the area and the legend";
  const std::string blocks = draw_stage(layout_of(disc()), {});
  int num_blocks = 0;
  for (const int region : {0, 1})
    for (const int shade : {0, 1, 2}) num_blocks += count(blocks, "fill=\"" + region_colour(region, shade) + "\"");
  EXPECT_EQ(num_blocks, 9 + 2) << "and two marks of the legend";
}

TEST(DrawRegions, RegionsOfOneNameAreOneInTheLegend) {
  SeparatrixGraph graph = disc();
  graph.face.region_names = {"air", "air"};
  DrawOptions options;
  options.curve_labels = CurveLabels::none;
  const std::string svg = draw_stage(graph, options);
  EXPECT_EQ(count(svg, ">air</text>"), 1);
  EXPECT_EQ(count(svg, region_colour(0)), 3) << "both areas and the legend";
}

TEST(DrawRegions, TintsDiffer) {
  std::set<std::string> colours;
  for (int region = 0; region < 6; ++region)
    for (int shade = 0; shade < 3; ++shade) colours.insert(region_colour(region, shade));
  EXPECT_EQ(colours.size(), 18u);
}

TEST(DrawRegions, OneRegionHasNoTints) {
  const SeparatrixGraph square = hand_made::unit_square();
  for (const std::string& svg : {draw_stage(square, {}), draw_stage(layout_of(square), {})}) {
    EXPECT_EQ(count(svg, " region"), 0);
    EXPECT_EQ(count(svg, region_colour(0)), 0);
  }
}

TEST(DrawRegions, TheLegendOfManyRegionsEnds) {
  std::vector<std::vector<std::vector<Nurbs>>> regions;
  for (int i = 0; i < 15; ++i) {
    const double x = 2 * i;
    const std::vector<Vec2> p{{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}};
    regions.push_back({{curve::segment(p[0], p[1]), curve::segment(p[1], p[2]), curve::segment(p[2], p[3]),
                        curve::segment(p[3], p[0])}});
  }
  SeparatrixGraph graph;
  graph.face = region_graphs::face(regions, 30);
  DrawOptions options;
  options.curve_labels = CurveLabels::none;
  const std::string svg = draw_stage(graph, options);
  EXPECT_EQ(count(svg, ">region_11</text>"), 1);
  EXPECT_EQ(count(svg, ">region_12</text>"), 0);
  EXPECT_EQ(count(svg, "and 3 more regions"), 1);
}

}  // namespace
}  // namespace quadrille::draw
