#include "mesh/element_sizes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::mesh {
namespace {

/// Columns of one row of quads of order N between the radii 1 and 1 + height: straight (on [0, 1] x [1, 1 + height]),
/// or around the origin from angle 0 to `ends.back()`.
QuadMesh row(int order, const std::vector<double>& ends, double height, bool is_round) {
  QuadMesh mesh;
  mesh.order = order;
  const std::vector<double>& points = spectral::gll_points(order);
  const int columns = static_cast<int>(ends.size()) - 1, width = columns * order + 1;
  for (int j = 0; j <= order; ++j)
    for (int i = 0; i < width; ++i) {
      const int column = std::min(i / order, columns - 1);
      const double s = (points[i - column * order] + 1) / 2, r = 1 + height * (points[j] + 1) / 2;
      const double x = ends[column] + s * (ends[column + 1] - ends[column]);
      mesh.nodes.push_back(is_round ? Vec2{r * std::cos(-x), r * std::sin(-x)} : Vec2{x, r});
    }
  for (int column = 0; column < columns; ++column) {
    for (int j = 0; j <= order; ++j)
      for (int i = 0; i <= order; ++i) mesh.elem_nodes.push_back(j * width + column * order + i);
    mesh.elem_block.push_back(0);
  }
  measure_element_sizes(mesh);
  return mesh;
}

TEST(ElementSizes, OfRectanglesAreThoseOfTheirSides) {
  const QuadMesh mesh = row(2, {0, 0.5, 0.75, 1.75}, 0.25, false);
  EXPECT_NEAR(mesh.elem_edge_ratio[0], 2, 1e-13);
  EXPECT_NEAR(mesh.elem_edge_ratio[1], 1, 1e-13);
  EXPECT_NEAR(mesh.elem_edge_ratio[2], 4, 1e-13);
  EXPECT_NEAR(mesh.elem_area_jump[0], 2, 1e-13);
  EXPECT_NEAR(mesh.elem_area_jump[1], 4, 1e-13);
  EXPECT_NEAR(mesh.elem_area_jump[2], 4, 1e-13);
  EXPECT_NEAR(mesh.elem_node_distance[1], 0.125, 1e-13);
}

TEST(ElementSizes, SidesAreMeasuredAlongTheirCurves) {
  const QuadMesh mesh = row(8, {0, 1}, 0.5, true);
  EXPECT_NEAR(mesh.elem_edge_ratio[0], 1.5 / 0.5, 1e-7);  // the outer arc over a radius; its chord would be shorter
  EXPECT_NEAR(mesh.elem_area_jump[0], 1, 1e-13);
}

TEST(ElementSizes, TheWorstAreNamedWithTheirPlaces) {
  QuadMesh mesh = row(3, {0, 0.5, 0.500001, 1}, 0.5, false);
  mesh.face.origin = {10, 20};
  const ElementSizes worst = worst_element_sizes(mesh);
  EXPECT_EQ(worst.edge_ratio_elem, 1);
  EXPECT_NEAR(worst.edge_ratio / 5e5, 1, 1e-9);
  EXPECT_NEAR(worst.edge_ratio_position.x, 10.5, 1e-5);
  EXPECT_NEAR(worst.edge_ratio_position.y, 21.25, 1e-12);
  EXPECT_NEAR(worst.area_jump / 5e5, 1, 1e-5);
  EXPECT_LT(worst.node_distance, 1e-6);
  EXPECT_NE(describe(worst).find("greatest edge ratio 5e+05 at (10.5, 21.25)"), std::string::npos) << describe(worst);
}

TEST(ElementSizes, OfAnElementWithoutExtentAreFinite) {
  QuadMesh mesh = row(1, {0, 0.5, 0.5, 1}, 0.5, false);
  EXPECT_EQ(mesh.elem_edge_ratio[1], 1e300);
  EXPECT_EQ(mesh.elem_area_jump[0], 1e300);
  EXPECT_EQ(mesh.elem_node_distance[1], 0);
}

}  // namespace
}  // namespace quadrille::mesh
