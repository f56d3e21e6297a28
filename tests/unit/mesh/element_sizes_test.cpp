#include "mesh/element_sizes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"
#include "mesh/nested_quads.hpp"
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
  EXPECT_NEAR(worst.edge_ratio_position.x, 0.5, 1e-5);
  EXPECT_NEAR(worst.edge_ratio_position.y, 1.25, 1e-12);
  EXPECT_NEAR(worst.area_jump / 5e5, 1, 1e-5);
  EXPECT_LT(worst.node_distance, 1e-6);
  EXPECT_NE(describe(worst, mesh.face).find("greatest edge ratio 5e+05 at (10.5, 21.25)"), std::string::npos)
      << describe(worst, mesh.face);
}

TEST(ElementSizes, OfAnElementWithoutExtentAreFinite) {
  QuadMesh mesh = row(1, {0, 0.5, 0.5, 1}, 0.5, false);
  EXPECT_EQ(mesh.elem_edge_ratio[1], 1e300);
  EXPECT_EQ(mesh.elem_area_jump[0], 1e300);
  EXPECT_EQ(mesh.elem_node_distance[1], 0);
}

/// Appends an element of which node (i, j) is at map(xi1, xi2) in [0, 1]^2; elements share no nodes.
template <class Map>
void append(QuadMesh& mesh, const Map& map) {
  const std::vector<double>& points = spectral::gll_points(mesh.order);
  for (const double y : points)
    for (const double x : points) {
      mesh.elem_nodes.push_back(static_cast<int>(mesh.nodes.size()));
      mesh.nodes.push_back(map((1 + x) / 2, (1 + y) / 2));
    }
  mesh.elem_block.push_back(0);
}

void append_rectangle(QuadMesh& mesh, double width, double height) {
  append(mesh, [&](double x, double y) { return Vec2{width * x, height * y}; });
}

QuadMesh empty_mesh(int order) {
  QuadMesh mesh;
  mesh.order = order;
  mesh.face.diameter = 7;
  return mesh;
}

TEST(Resolution, OfEqualSquaresIsOne) {
  QuadMesh mesh = empty_mesh(3);
  for (int i = 0; i < 4; ++i) append_rectangle(mesh, 0.2, 0.2);
  EXPECT_NEAR(resolution(mesh).ratio, 1, 1e-12);
  for (const auto& parts : resolution(mesh).parts) EXPECT_NEAR(parts[0], 0.125, 1e-12);
}

TEST(Resolution, OfRectanglesHasTheEighthPowerOfTheirSides) {
  QuadMesh mesh = empty_mesh(1);
  append_rectangle(mesh, 2, 1);
  const Resolution of = resolution(mesh);
  EXPECT_NEAR(of.ratio, (256 + 1) / (2 * 16.0), 1e-12);
  EXPECT_NEAR(of.parts[0][0], 256 / 257.0, 1e-12);
  EXPECT_NEAR(of.parts[0][1], 1 / 257.0, 1e-12);
}

TEST(Resolution, OfARingIsThatOfTheIntegral) {
  QuadMesh mesh = empty_mesh(8);
  append(mesh, [](double s, double t) {
    return Vec2{(1 + s) * std::cos(half_pi * t), (1 + s) * std::sin(half_pi * t)};
  });
  // |x_s| = 1, |x_t| = r pi/2, dA = r pi/2 dr dt
  const double area = half_pi * 1.5, along = area, across = std::pow(half_pi, 9) * (std::pow(2, 10) - 1) / 10;
  EXPECT_NEAR(resolution(mesh).ratio / ((along + across) / (2 * std::pow(area, 5))), 1, 1e-6);
}

TEST(Resolution, SquaresOfThePrescribedSizesAreIdeal) {
  QuadMesh mesh = empty_mesh(2);
  append_rectangle(mesh, 1, 1);
  append_rectangle(mesh, 2, 2);
  EXPECT_GT(resolution(mesh).ratio, 2);
  mesh.elem_prescribed_length = {0.5, 1};
  EXPECT_NEAR(resolution(mesh).ratio, 1, 1e-12);
  EXPECT_NEAR(relative_sizes(mesh)[1], 2, 1e-12);
}

TEST(Resolution, LengthsHaveLimitsOfTheirOwn) {
  QuadMesh mesh = empty_mesh(2);
  append_rectangle(mesh, 1, 1);
  append_rectangle(mesh, 1, 0.25);
  mesh.elem_prescribed_length = {0.5, 0.5};
  EXPECT_GT(resolution(mesh).ratio, 1.5);
  const Resolution of = resolution(mesh, {{1, 7}, {7, 0.125}});
  EXPECT_NEAR(of.ratio, 1, 1e-12);
  EXPECT_NEAR(of.parts[1][1], 0.25, 1e-12);
}

TEST(Resolution, InAMetricRectanglesOfItsLengthsAreIdeal) {
  QuadMesh mesh = empty_mesh(2);
  append_rectangle(mesh, 1, 0.25);
  append_rectangle(mesh, 0.5, 0.5);
  mesh.elem_prescribed_length = {0.5, 0.5};
  EXPECT_GT(resolution(mesh).ratio, 2);
  mesh.elem_prescribed_stretch = {tensor_of({2, 0.5, half_pi}), {}};
  EXPECT_NEAR(resolution(mesh).ratio, 1, 1e-12);
  EXPECT_EQ(nested_quads(mesh, 1).elem_prescribed_stretch[3].yy, mesh.elem_prescribed_stretch[0].yy);
}

TEST(Resolution, ElementsOfLayersDoNotCount) {
  QuadMesh mesh = empty_mesh(2);
  append_rectangle(mesh, 1, 1);
  append_rectangle(mesh, 1, 1e-3);
  mesh.elem_prescribed_length = {0.5, 0};
  EXPECT_NEAR(resolution(mesh).ratio, 1, 1e-12);
  EXPECT_EQ(resolution(mesh).parts[1][0], 0);
  mesh.elem_prescribed_length = {0, 0};
  EXPECT_EQ(resolution(mesh).ratio, 1);
}

TEST(Resolution, OfNestedElementsIsTheSame) {
  QuadMesh mesh = empty_mesh(4);
  append(mesh, [](double s, double t) { return Vec2{s + 0.2 * t * t, (1 + s * s) * t}; });
  append_rectangle(mesh, 1, 0.5);
  mesh.elem_prescribed_length = {0.5, 0.4};
  const QuadMesh nested = nested_quads(mesh, 1);
  EXPECT_NEAR(nested.elem_prescribed_length[7], 0.2, 1e-15);
  EXPECT_NEAR(resolution(nested).ratio / resolution(mesh).ratio, 1, 1e-4);
}

}  // namespace

}  // namespace quadrille::mesh
