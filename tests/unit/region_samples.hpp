#pragma once
// Small valid stage files of several regions for the tests of io and check: two unit squares side by side, a fluid and
// a solid that share the side x = 1; and a square with a slit.

#include "samples.hpp"

namespace quadrille::samples {

inline Vec2 shifted(Vec2 p, double x) { return {p.x + x, p.y}; }

/// Curves 0 to 3 are the sides of the left square, 4 to 7 those of the right one; 1 and 7 are the interface. Both are
/// periodic from below to above.
inline CadFace two_regions_face() {
  CadFace f = face();
  f.diameter = std::sqrt(5.0);
  const CadFace one = f;
  for (std::size_t k = 0; k < 4; ++k) {
    f.curves.push_back(line(shifted(one.curves[k].poles[0], 1), shifted(one.curves[k].poles[1], 1)));
    f.curve_cad_edges.push_back(static_cast<int>(k) + 4);
    f.joints.push_back(one.joints[k]);
    f.joints.back().position.x += 1;
  }
  f.curve_names = {"bottom", "fluid-solid", "top", "inlet", "bottom", "outer", "top", "fluid-solid"};
  f.unnamed_curves = {1, 7};
  f.loop_offsets = {0, 4, 8};
  f.region_loops = {0, 1, 2};
  f.region_names = {"fluid", "solid"};
  f.partners = {-1, 7, -1, -1, -1, -1, -1, 1};
  f.periodic_pairs = {{{0, 2}, 0, {0, 1}}, {{4, 6}, 0, {0, 1}}};
  return f;
}

/// Four triangles in each square, as in tri_mesh().
inline TriMesh two_regions_mesh() {
  TriMesh m = tri_mesh();
  m.face = two_regions_face();
  const TriMesh one = m;
  for (const Vec2 vertex : one.vertices) m.vertices.push_back(shifted(vertex, 1));
  for (const auto& [a, b, c] : one.elem2vertices) m.elem2vertices.push_back({a + 5, b + 5, c + 5});
  for (const BoundaryEdge& edge : one.boundary_edges)
    m.boundary_edges.push_back({edge.elem + 4, edge.edge, edge.curve + 4, edge.t0, edge.t1});
  m.elem_layer.assign(8, -1);
  m.region_elems = {0, 4, 8};
  return m;
}

/// v = (1, 0) on both.
inline Field two_regions_field() {
  Field f = field();
  f.mesh = two_regions_mesh();
  f.mesh.provenance = f.provenance;
  f.elem_order.assign(8, 1);
  f.coef_offsets = {0, 3, 6, 9, 12, 15, 18, 21, 24};
  f.u.assign(24, 0.0);
  f.v.assign(24, 0.0);
  for (std::size_t e = 0; e < 8; ++e) f.u[3 * e] = 1.4142135623730951;
  f.adapt_steps.clear();
  f.elem_sensor.clear();
  f.elem_error.clear();
  return f;
}

inline CriticalPoints two_regions_points() {
  CriticalPoints c;
  c.provenance = provenance();
  c.face = two_regions_face();
  for (int j = 0; j < 8; ++j) {
    const Joint& joint = c.face.joints[static_cast<std::size_t>(j)];
    c.corners.push_back({j, joint.position, 90, 1, {c.face.previous_in_loop(j), j}});
  }
  c.index_sum = 8;
  c.index_sum_expected = 8;
  return c;
}

/// A phase in each: on the left one node of valence 3, as in phase_field(), on the right none. Joints of region_phases
/// count from 0 in each region.
inline Field two_regions_phase_field() {
  Field f = two_regions_field();
  const Field left = phase_field();
  f.kind = FieldKind::phase;
  f.u.clear();
  f.v.clear();
  PhaseForm right;
  for (int k = 0; k < 4; ++k) right.prescribed.corners.push_back({k, 1});
  f.region_phases = {left.phase, right};
  for (PhaseForm& phase : f.region_phases) phase.s.assign(12, 0.0);
  return f;
}

/// The square with a slit from (0.25, 0.5) to (0.75, 0.5), a loop of its own: curves 4 and 5.
inline CadFace slit_face() {
  CadFace f = face();
  const Vec2 left{0.25, 0.5}, right{0.75, 0.5};
  for (const auto& [a, b] : {std::pair(left, right), std::pair(right, left)}) {
    f.curves.push_back(line(a, b));
    f.curve_names.emplace_back("crack");
    f.curve_cad_edges.push_back(4);
  }
  f.joints.push_back({left, pi, 0, 2 * pi, true});
  f.joints.push_back({right, 0, pi, 2 * pi, true});
  f.loop_offsets = {0, 4, 6};
  f.partners = {-1, -1, -1, -1, 5, 4};
  return f;
}

/// Eight triangles; vertices 6 and 7 are the middle of the slit, above and below.
inline TriMesh slit_mesh() {
  TriMesh m;
  m.provenance = provenance();
  m.face = slit_face();
  m.order = 1;
  m.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.25, 0.5}, {0.75, 0.5}, {0.5, 0.5}, {0.5, 0.5}};
  m.elem2vertices = {{0, 1, 7}, {1, 5, 7}, {0, 7, 4}, {2, 3, 6}, {3, 4, 6}, {2, 6, 5}, {3, 0, 4}, {1, 2, 5}};
  m.boundary_edges = {{0, 0, 0, 0, 1},   {7, 0, 1, 0, 1},   {3, 0, 2, 0, 1},   {6, 0, 3, 0, 1},
                      {4, 1, 4, 0, 0.5}, {5, 1, 4, 0.5, 1}, {1, 1, 5, 0, 0.5}, {2, 1, 5, 0.5, 1}};
  m.elem_layer.assign(8, -1);
  return m;
}

}  // namespace quadrille::samples
