#include "refine/surface_tips.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/nurbs_surface.hpp"

namespace quadrille::refine {
namespace {

/// A quarter of a cone with its tip at (0, 0, height), which is a disc if that is 0, in two triangles at the tip.
Chart quarter_of_cone(double height) {
  NurbsSurface s;
  s.degree_u = 2, s.degree_v = 1;
  s.knots_u = {0, 0, 0, 1, 1, 1}, s.knots_v = {0, 0, 1, 1};
  const Vec3 tip{0, 0, height};
  s.poles = {tip, {1, 0, 0}, tip, {1, 1, 0}, tip, {0, 1, 0}};
  s.weights = {1, 1, std::sqrt(0.5), std::sqrt(0.5), 1, 1};
  Chart chart;
  chart.elem2vertices = {{0, 1, 2}, {0, 2, 3}};
  chart.uv = {{0, 0}, {0, 1}, {0.5, 1}, {0.5, 0}, {0.5, 1}, {1, 1}};
  for (const Vec2 uv : chart.uv) chart.space_nodes.push_back(surface::point(s, uv));
  chart.elem_surface = {0, 0};
  chart.surfaces = {s};
  return chart;
}

TEST(SurfaceTips, AConeHasATipAndADiscHasNone) {
  const std::vector<Vec3> tips = surface_tips(quarter_of_cone(1));
  ASSERT_EQ(tips.size(), 1U);
  EXPECT_EQ(distance(tips[0], Vec3{0, 0, 1}), 0);
  EXPECT_TRUE(surface_tips(quarter_of_cone(0)).empty());
}

}  // namespace
}  // namespace quadrille::refine
