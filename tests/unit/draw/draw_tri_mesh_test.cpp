#include <gtest/gtest.h>

#include "../region_samples.hpp"
#include "square_samples.hpp"

namespace quadrille::draw {
namespace {

TEST(DrawTriMesh, TriMeshShowsEveryElement) {
  const std::string svg = draw_stage(two_triangles(), {});
  expect_sound(svg);
  EXPECT_EQ(count(svg, "id=\"elem-"), 2);
  EXPECT_EQ(count(svg, "<title>boundary curve"), 4);
  EXPECT_EQ(count(svg, "<title>corner at"), 4);
  EXPECT_EQ(count(svg, "boundary curve 1: out &lt; let"), 1);
  EXPECT_EQ(svg, draw_stage(two_triangles(), {}));
}

TEST(DrawTriMesh, WidthIsThatOfTheOptions) {
  DrawOptions options;
  options.width = 640;
  EXPECT_EQ(count(draw_stage(two_triangles(), options), "width=\"640\""), 1);
}

TEST(DrawTriMesh, InterfacesAndSlitsAreDrawnOnce) {
  const std::string regions = draw_stage(samples::two_regions_mesh(), {});
  expect_sound(regions);
  EXPECT_EQ(count(regions, "<title>boundary curve"), 6);
  EXPECT_EQ(count(regions, "<title>interface, curves 1 and 7: fluid-solid"), 1);
  EXPECT_EQ(count(regions, "class=\"interface\""), 2) << "the line and its mark in the legend";
  EXPECT_EQ(count(regions, ">interface of two regions<"), 1);
  EXPECT_EQ(count(regions, ">fluid<"), 1);
  EXPECT_EQ(count(regions, ">solid<"), 1);
  EXPECT_EQ(count(regions, ", 2 regions"), 1);
  const std::string slit = draw_stage(samples::slit_mesh(), {});
  EXPECT_EQ(count(slit, "<title>slit, curves 4 and 5: crack"), 1);
  EXPECT_EQ(count(slit, "class=\"slit\""), 2);
  EXPECT_EQ(count(slit, "class=\"interface\""), 0);
  EXPECT_EQ(count(slit, "regions"), 0);
}

TEST(DrawTriMesh, LayersOfCornerFansAndCurvedElementsAreTinted) {
  const std::string svg = draw_stage(two_triangles(), {});
  expect_counts(svg, {{"<title>triangle 1, layer 0 of a corner fan<", 1}, {">corner fan<", 1}, {">curved<", 0}});
  const std::string curved = draw_stage(samples::tri_mesh(), {});
  expect_counts(curved, {{">corner fan<", 0}, {">curved<", 1}, {"4 triangles, 1 of them curved (order 2)", 1}});
}

}  // namespace
}  // namespace quadrille::draw
