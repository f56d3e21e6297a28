// Every picture of small models made by hand: the number of elements, no value that is no number, the same bytes twice.
#include "draw/draw.hpp"

#include <gtest/gtest.h>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille {
namespace {

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++n;
  return n;
}

void expect_sound(const std::string& svg) {
  EXPECT_EQ(count(svg, "nan"), 0);
  EXPECT_EQ(count(svg, "inf"), 0);
  EXPECT_EQ(svg.rfind("<?xml", 0), 0u);
  EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
  EXPECT_EQ(count(svg, "http"), 1) << "only the name space";
}

/// The unit square as a face; its curve 1 is called "out < let".
CadFace square() {
  CadFace face;
  const Vec2 corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int i = 0; i < 4; ++i) {
    face.curves.push_back(segment(corners[i], corners[(i + 1) % 4]));
    face.joints.push_back({corners[i], wrap_pi(half_pi * (i - 1)), wrap_pi(half_pi * i), half_pi, true});
  }
  face.curve_names = {"wall", "out < let", "", ""};
  face.curve_cad_edges = {0, 1, 2, 3};
  face.loop_offsets = {0, 4};
  face.diameter = std::sqrt(2.0);
  return face;
}

TriMesh two_triangles() {
  TriMesh mesh;
  mesh.face = square();
  mesh.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.elem2vertices = {{0, 1, 2}, {0, 2, 3}};
  mesh.boundary_edges = {{0, 0, 0, 0, 1}, {0, 1, 1, 0, 1}, {1, 1, 2, 0, 1}, {1, 2, 3, 0, 1}};
  mesh.elem_layer = {-1, 0};
  return mesh;
}

/// u = 2 x - 1, v = 2 y - 1: zero in the middle.
Field linear_field() {
  Field field;
  field.mesh = two_triangles();
  field.elem_order = {1, 1};
  field.coef_offsets = {0, 3, 6};
  // The orthonormal basis of degree 1: sqrt(1/2), then sqrt(3/4)-ish multiples; fitted through the vertices.
  for (int e = 0; e < 2; ++e) {
    const auto& v = field.mesh.elem2vertices[e];
    const auto coefs = [&](auto f) {
      const double a = f(field.mesh.vertices[v[0]]), b = f(field.mesh.vertices[v[1]]), c = f(field.mesh.vertices[v[2]]);
      const double mean = (a + b + c) / 3;
      // f = mean + c1 phi1 + c2 phi2 with phi(0, 1) ~ (1 + 3 xi2) / 2 and phi(1, 0) ~ xi1 + (1 + xi2) / 2.
      const double along2 = (c - mean), along1 = (b - a) / 2;
      return std::array<double, 3>{mean * std::sqrt(2.0), along2, along1 * 2 / std::sqrt(3.0)};
    };
    for (const double value : coefs([](Vec2 x) { return 2 * x.x - 1; })) field.u.push_back(value);
    for (const double value : coefs([](Vec2 x) { return 2 * x.y - 1; })) field.v.push_back(value);
  }
  return field;
}

TEST(Draw, TriMeshShowsEveryElement) {
  const std::string svg = draw_tri_mesh(two_triangles(), {});
  expect_sound(svg);
  EXPECT_EQ(count(svg, "id=\"elem-"), 2);
  EXPECT_EQ(count(svg, "<title>boundary curve"), 4);
  EXPECT_EQ(count(svg, "<title>corner at"), 4);
  EXPECT_EQ(count(svg, "boundary curve 1: out &lt; let"), 1);
  EXPECT_EQ(svg, draw_tri_mesh(two_triangles(), {}));
}

TEST(Draw, WidthIsThatOfTheOptions) {
  DrawOptions options;
  options.width = 640;
  EXPECT_EQ(count(draw_tri_mesh(two_triangles(), options), "width=\"640\""), 1);
}

TEST(Draw, FieldShowsCellsAndBothZeroContours) {
  for (const char* show : {"psi", "u", "v"}) {
    DrawOptions options;
    options.show = show;
    const std::string svg = draw_field(linear_field(), options);
    expect_sound(svg);
    EXPECT_GT(count(svg, "<path fill="), 10) << show;
    EXPECT_GE(count(svg, "class=\"zero-u\""), 1) << show;
    EXPECT_GE(count(svg, "class=\"zero-v\""), 1) << show;
    EXPECT_EQ(svg, draw_field(linear_field(), options));
  }
}

TEST(Draw, OrderMapShowsEveryElement) {
  DrawOptions options;
  options.show = "order";
  const std::string svg = draw_field(linear_field(), options);
  expect_sound(svg);
  EXPECT_EQ(count(svg, "id=\"elem-"), 2);
}

TEST(Draw, UnknownQuantityIsAUsageError) {
  DrawOptions options;
  options.show = "w";
  EXPECT_THROW(draw_field(linear_field(), options), UsageError);
}

TEST(Draw, CriticalPointsShowValences) {
  CriticalPoints points;
  points.critical_points = {{{0.5, 0.5}, 1, 3, 0, {}, {}}, {{0.25, 0.5}, -1, 5, 0, {}, {}}};
  points.corners = {{0, {0, 0}, 90, 1, {3, 0}}};
  const std::string alone = draw_critical_points(points, nullptr, {});
  expect_sound(alone);
  EXPECT_EQ(count(alone, "<title>critical point of valence 3"), 1);
  EXPECT_EQ(count(alone, "<title>critical point of valence 5"), 1);
  const Field field = linear_field();
  const std::string with_field = draw_critical_points(points, &field, {});
  expect_sound(with_field);
  EXPECT_EQ(count(with_field, "<title>boundary curve"), 4);
}

TEST(Draw, NoCriticalPointsAtAllIsAPictureToo) { expect_sound(draw_critical_points({}, nullptr, {})); }

SeparatrixGraph halved_square() {
  SeparatrixGraph graph;
  graph.face = square();
  graph.splines = {segment({0, 0.5}, {1, 0.5})};
  for (int i = 0; i < 4; ++i) graph.nodes.push_back({graph.face.joints[i].position, NodeKind::corner, 1, i, 0});
  graph.nodes.push_back({{1, 0.5}, NodeKind::boundary, 2, 1, 0.5});
  graph.nodes.push_back({{0, 0.5}, NodeKind::cut, 2, 3, 0.5});
  graph.arcs = {{0, 1, true, 0, {{0, 0, 1}}}, {1, 4, true, 0, {{1, 0, 0.5}}}, {4, 2, true, 0, {{1, 0.5, 1}}},
                {2, 3, true, 0, {{2, 0, 1}}}, {3, 5, true, 0, {{3, 0, 0.5}}}, {5, 0, true, 0, {{3, 0.5, 1}}},
                {5, 4, false, 0, {{4, 0, 1}}}};
  graph.lines = {{5, 4, "cut", {6}}};
  return graph;
}

TEST(Draw, SeparatricesShowLinesAndNodes) {
  const std::string svg = draw_separatrix_graph(halved_square(), {});
  expect_sound(svg);
  EXPECT_EQ(count(svg, "id=\"line-"), 1);
  EXPECT_EQ(count(svg, "<title>node "), 6);
}

TEST(Draw, ArcsOfNoLineAreDrawnAllTheSame) {
  SeparatrixGraph graph = halved_square();
  graph.lines.clear();
  EXPECT_EQ(count(draw_separatrix_graph(graph, {}), "<title>arc 6<"), 1);
}

TEST(Draw, BlocksShowNumbersInTheirMiddle) {
  const SeparatrixGraph graph = halved_square();
  BlockLayout layout;
  layout.face = graph.face;
  layout.splines = graph.splines;
  layout.nodes = graph.nodes;
  layout.arcs = graph.arcs;
  layout.block2nodes = {{0, 1, 4, 5}, {5, 4, 2, 3}};
  layout.block2arcs = {{0, 1, -7, 5}, {6, 2, 3, 4}};
  layout.arc_chord = {0, 1, 2, 0, 2, 1, 0};
  layout.block_names = {"inlet block", ""};
  DrawOptions options;
  options.width = 1072;  // 1000 pixels a unit
  const std::string svg = draw_block_layout(layout, options);
  expect_sound(svg);
  EXPECT_EQ(count(svg, "id=\"block-"), 2);
  EXPECT_EQ(count(svg, "<title>block 0: inlet block<"), 1);
  EXPECT_EQ(count(svg, "x=\"500\" y=\"754\">0</text>"), 1) << svg;
  EXPECT_EQ(count(svg, "x=\"500\" y=\"254\">1</text>"), 1);
  EXPECT_EQ(count(svg, "3 chords"), 1);
}

/// Two quads of order N side by side in the unit square, the right one with the given quality.
QuadMesh two_quads(int order, double quality) {
  QuadMesh mesh;
  mesh.face = square();
  mesh.order = order;
  const auto& points = gll_points(order);
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

TEST(Draw, QuadsAreColouredAndTheWorstIsRinged) {
  const std::string svg = draw_quad_mesh(two_quads(3, 0.25), {});
  expect_sound(svg);
  EXPECT_EQ(count(svg, "id=\"elem-"), 2);
  EXPECT_EQ(count(svg, "<title>quad 1 at (0.75, 0.5): scaled Jacobian 0.250<"), 1);
  EXPECT_EQ(count(svg, "<circle class=\"ring\""), 2) << "the ring and its legend";
  EXPECT_EQ(count(svg, "class=\"edge\""), 1) << "the border between two blocks";
}

TEST(Draw, PerfectMeshHasNoRing) { EXPECT_EQ(count(draw_quad_mesh(two_quads(1, 1), {}), "class=\"ring\""), 0); }

}  // namespace
}  // namespace quadrille
