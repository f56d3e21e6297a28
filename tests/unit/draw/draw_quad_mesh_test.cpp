#include <gtest/gtest.h>

#include "../samples.hpp"
#include "spectral/quadrature.hpp"
#include "square_samples.hpp"

namespace quadrille::draw {
namespace {

/// Two quads of order N side by side in the unit square, the right one with the given quality.
QuadMesh two_quads(int order, double quality) {
  QuadMesh mesh;
  mesh.face = square();
  mesh.order = order;
  const auto& points = spectral::gll_points(order);
  const int m = order + 1;
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < 2 * order + 1; ++i) {
      const double s = i <= order ? (points[i] + 1) / 4 : 0.5 + (points[i - order] + 1) / 4;
      mesh.nodes.push_back({s, (points[j] + 1) / 2});
    }
  for (int e = 0; e < 2; ++e)
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < m; ++i) mesh.elem_nodes.push_back(j * (2 * order + 1) + e * order + i);
  mesh.elem_block = {0, 1};
  mesh.elem_jacobian_bound = {0.1, 0.1};
  mesh.elem_scaled_jacobian = {1, quality};
  return mesh;
}

TEST(DrawQuadMesh, QuadsAreColouredAndTheWorstIsRinged) {
  const std::string svg = draw_stage(two_quads(3, 0.25), {});
  expect_sound(svg);
  EXPECT_EQ(count(svg, "id=\"elem-"), 2);
  EXPECT_EQ(count(svg, "<title>quad 1 at (0.75, 0.5): scaled Jacobian 0.250<"), 1);
  EXPECT_EQ(count(svg, "<circle class=\"ring\""), 2) << "the ring and its legend";
  EXPECT_EQ(count(svg, "class=\"edge\""), 1) << "the border between two blocks";
}

TEST(DrawQuadMesh, QuadsThatAreNotProvedAreOutlinedAndSaid) {
  QuadMesh mesh = two_quads(2, -1);
  EXPECT_EQ(count(draw_stage(mesh, {}), "class=\"worst\""), 0);
  mesh.elem_jacobian_bound[1] = -0.2;
  mesh.is_valid = false;
  const std::string svg = draw_stage(mesh, {});
  expect_sound(svg);
  EXPECT_EQ(count(svg, "class=\"worst\""), 2) << "the quad and the legend";
  EXPECT_EQ(count(svg, "not proved valid (1)<"), 1);
  EXPECT_EQ(count(svg, "NOT VALID: 2 quads"), 1);
}

TEST(DrawQuadMesh, LengthsOfQuadsAreInTheCaptionIfTheFileHasThem) {
  QuadMesh mesh = two_quads(2, 0.5);
  EXPECT_EQ(count(draw_stage(mesh, {}), "edge ratio"), 0);
  mesh.elem_edge_ratio = {1, 2.5};
  mesh.elem_area_jump = {3, 3};
  mesh.elem_node_distance = {0.25, 0.125};
  DrawOptions wide;  // enough for a caption of one line
  wide.width = 1500;
  const std::string svg = draw_stage(mesh, wide);
  EXPECT_EQ(count(svg, "greatest edge ratio 2.5, greatest area jump 3, least node distance 0.125<"), 1);
  EXPECT_EQ(count(svg, "scaled Jacobian 0.500, edge ratio 2.5<"), 1);
}

TEST(DrawQuadMesh, OnlyTheWorstIsRingedAndOnlyIfItIsPoor) {
  QuadMesh mesh = two_quads(1, 0.49);
  mesh.elem_scaled_jacobian[0] = 0.49;
  EXPECT_EQ(count(draw_stage(mesh, {}), "<circle class=\"ring\""), 2) << "the ring and its legend";
  for (const double quality : {0.5, 1.0})
    EXPECT_EQ(count(draw_stage(two_quads(1, quality), {}), "class=\"ring\""), 0) << quality;
}

TEST(DrawQuadMesh, AMeshByAMetricShowsItsDirections) {
  QuadMesh mesh = samples::quad_mesh();
  mesh.elem_prescribed_stretch = {{}, {}};
  EXPECT_EQ(count(draw_stage(mesh, {}), "class=\"prescribed\""), 0) << "lengths are equal";
  mesh.elem_prescribed_stretch = {{}, tensor_of({2, 0.5, 0})};
  const std::string svg = draw_stage(mesh, {});
  expect_sound(svg);
  EXPECT_EQ(count(svg, "class=\"prescribed\""), 2) << "one path, and that of the legend";
}

}  // namespace
}  // namespace quadrille::draw
