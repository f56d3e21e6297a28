#pragma once
// Small models of the unit square, made by hand, for tests of pictures.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "draw/draw.hpp"

namespace quadrille::draw {

/// Texts without a value that is no number, in one element.
inline void expect_sound(const std::string& svg) {
  EXPECT_EQ(count(svg, "nan"), 0);
  EXPECT_EQ(count(svg, "inf"), 0);
  EXPECT_EQ(svg.rfind("<?xml", 0), 0u);
  EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
  EXPECT_EQ(count(svg, "http"), 1) << "only the name space";
}

/// `field` may be null.
inline std::string draw_points(const CriticalPoints& points, const Field* field, DrawOptions options) {
  options.field = field;
  return draw_stage(points, options);
}

/// The unit square as a face; its curve 1 is called "out < let".
inline CadFace square() {
  CadFace face;
  const Vec2 corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int i = 0; i < 4; ++i) {
    face.curves.push_back(curve::segment(corners[i], corners[(i + 1) % 4]));
    face.joints.push_back({corners[i], wrap_pi(half_pi * (i - 1)), wrap_pi(half_pi * i), half_pi, true});
  }
  face.curve_names = {"wall", "out < let", "", ""};
  face.curve_cad_edges = {0, 1, 2, 3};
  face.loop_offsets = {0, 4};
  face.diameter = std::sqrt(2.0);
  return face;
}

inline TriMesh two_triangles() {
  TriMesh mesh;
  mesh.face = square();
  mesh.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.elem2vertices = {{0, 1, 2}, {0, 2, 3}};
  mesh.boundary_edges = {{0, 0, 0, 0, 1}, {0, 1, 1, 0, 1}, {1, 1, 2, 0, 1}, {1, 2, 3, 0, 1}};
  mesh.elem_layer = {-1, 0};
  return mesh;
}

/// u = 2 x - 1, v = 2 y - 1: zero in the middle.
inline Field linear_field() {
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

/// Of the square.
inline DrawOptions thousand_pixels_a_unit() {
  DrawOptions options;
  options.width = 1072;
  return options;
}

/// Half a turn of the square's cross field: phi = 0, one node of valence 3 asked for (its terms are not drawn).
inline Field phase_field() {
  Field field = linear_field();
  field.kind = FieldKind::phase;
  field.phase.s.assign(field.u.size(), 0.0);
  field.u.clear();
  field.v.clear();
  field.phase.prescribed.nodes = {{{0.5, 0.5}, 3}};
  field.phase.prescribed.corners = {{0, 2}};
  field.phase.prescribed.boundary_nodes = {{1, 0.25, 3}};
  return field;
}

inline SeparatrixGraph halved_square() {
  SeparatrixGraph graph;
  graph.face = square();
  graph.splines = {curve::segment({0, 0.5}, {1, 0.5})};
  for (int i = 0; i < 4; ++i) graph.nodes.push_back({graph.face.joints[i].position, NodeKind::corner, 1, i, 0});
  graph.nodes.push_back({{1, 0.5}, NodeKind::boundary, 2, 1, 0.5});
  graph.nodes.push_back({{0, 0.5}, NodeKind::cut, 2, 3, 0.5});
  graph.arcs = {{0, 1, true, 0, {{0, 0, 1}}}, {1, 4, true, 0, {{1, 0, 0.5}}}, {4, 2, true, 0, {{1, 0.5, 1}}},
                {2, 3, true, 0, {{2, 0, 1}}}, {3, 5, true, 0, {{3, 0, 0.5}}}, {5, 0, true, 0, {{3, 0.5, 1}}},
                {5, 4, false, 0, {{4, 0, 1}}}};
  graph.lines = {{5, 4, LineKind::cut, {6}}};
  return graph;
}

}  // namespace quadrille::draw
