#pragma once
// Small valid stage files for the tests of io and check: the square [0,1]^2, whole, with one field, one block.

#include "model/block_layout.hpp"
#include "model/critical_points.hpp"
#include "model/field.hpp"
#include "model/hex_mesh.hpp"
#include "model/quad_mesh.hpp"
#include "model/separatrix_graph.hpp"
#include "model/tri_mesh.hpp"
#include "support/block_sides.hpp"

namespace quadrille::samples {

inline constexpr double pi = 3.14159265358979323846;

inline Nurbs line(Vec2 a, Vec2 b) { return {1, {0, 0, 1, 1}, {a, b}, {1, 1}}; }

inline Provenance provenance() {
  return {{"cad2tri", "0.1.0", {{"step", std::string(64, 'a')}}, R"({"corner-angle":1,"order":8})"}};
}

/// The unit square: curve k runs along side k, counter-clockwise.
inline CadFace face() {
  CadFace f;
  f.name = "square";
  f.length_unit = "millimetre";
  f.metres_per_unit = 0.001;
  f.diameter = 1.4142135623730951;
  f.fit_distance = 1e-10;
  const Vec2 p[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const double out[4] = {0, pi / 2, pi, -pi / 2};
  for (int k = 0; k < 4; ++k) {
    f.curves.push_back(line(p[k], p[(k + 1) % 4]));
    f.curve_names.push_back("side " + std::to_string(k));
    f.curve_cad_edges.push_back(k);
    f.joints.push_back({p[k], out[(k + 3) % 4], out[k], pi / 2, true});
  }
  f.loop_offsets = {0, 4};
  return f;
}

/// Four triangles around the centre; element 0 (below) is curved of order 2, with its nodes where the affine map has
/// them.
inline TriMesh tri_mesh() {
  TriMesh m;
  m.provenance = provenance();
  m.face = face();
  m.order = 2;
  m.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}};
  m.elem2vertices = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  m.curved_elems = {0};
  m.curved_nodes = {{0, 0}, {1, 0}, {0.5, 0.5}, {0.5, 0}, {0.75, 0.25}, {0.25, 0.25}};
  for (int k = 0; k < 4; ++k) m.boundary_edges.push_back({k, 0, k, 0, 1});
  m.elem_layer = {-1, -1, -1, -1};
  m.repairs = {{RepairKind::joint, 1, {1, 1}, 1e-6}};
  return m;
}

/// v = (1, 0): the first orthonormal mode of the reference triangle (area 2) is 1 / sqrt(2).
inline Field field() {
  Field f;
  f.provenance = provenance();
  f.provenance.push_back({"fieldsolve", "0.1.0", {{"tri-mesh", std::string(64, 'b')}}, R"({"field-order":1})"});
  f.mesh = tri_mesh();
  f.mesh.provenance = f.provenance;
  f.elem_order = {1, 1, 2, 1};
  f.coef_offsets = {0, 3, 6, 12, 15};
  f.u.assign(15, 0.0);
  f.v.assign(15, 0.0);
  for (const int first : {0, 3, 6, 12}) f.u[static_cast<std::size_t>(first)] = 1.4142135623730951;
  f.adapt_steps = {{25, 1, 0, 1, 2, 1e-9, {1, 1, 1, 1}, {0, 0, 1e-9, 0}}};
  f.elem_sensor = {0, 0, 1e-12, 0};
  f.elem_error = {0, 0, 1e-6, 0};
  return f;
}

inline CriticalPoints critical_points() {
  CriticalPoints c;
  c.provenance = provenance();
  c.critical_points = {{{0.25, 0.5}, 1, 3, 3, {-0.5, -0.25}, {2, 0, 0, 1}, 1e-9},
                       {{0.75, 0.5}, -1, 5, 1, {-0.5, -0.25}, {1, 0, 0, -1}, 2e-9}};
  const Vec2 p[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int k = 0; k < 4; ++k) c.corners.push_back({k, p[k], 90, 1, {(k + 3) % 4, k}});
  c.index_sum = 4;
  c.index_sum_expected = 4;
  return c;
}

/// What was made of a field's zeros (invented, to show every member): one of index 2 became two nodes, one near a
/// corner was absorbed, one was put onto the boundary.
inline CriticalPoints resolved_points() {
  CriticalPoints c = critical_points();
  c.form = NodeForm::phase;
  c.zeros = {{{0.25, 0.5}, 2, 2, 3, {-0.5, -0.25}, {0, 0, 0, 0}, 1e-6},
             {{0.75, 0.5}, -1, 5, 1, {-0.5, -0.25}, {1, 0, 0, -1}, 2e-9},
             {{0.03125, 0.015625}, -1, 5, 0, {-0.953125, -0.96875}, {2, 0, 0, -1}, 1e-9}};
  c.critical_points = {{{0.25, 0.375}, 1, 3, 3, {-0.625, -0.25}, {}, 0, NodeSource::cluster},
                       {{0.25, 0.625}, 1, 3, 3, {-0.375, -0.25}, {}, 0, NodeSource::cluster}};
  c.corners[0].valence = 2;
  c.corners[0].source = NodeSource::absorb;
  c.boundary_nodes = {{1, 0.5, {1, 0.5}, 3, NodeSource::feature}};
  c.clusters = {{{0.25, 0.5}, 0.001, 2, {{0.25, 0.5}}, {}}};
  c.changes = {{ChangeKind::cluster,
                "a zero of index 2 becomes two nodes of valence 3",
                {{{0.25, 0.5}, 2, NodeLocation::inside}},
                {{{0.25, 0.375}, 3, NodeLocation::inside}, {{0.25, 0.625}, 3, NodeLocation::inside}}},
               {ChangeKind::absorb,
                "nearer to the corner than any block could be",
                {{{0, 0}, 1, NodeLocation::corner}, {{0.03125, 0.015625}, 5, NodeLocation::inside}},
                {{{0, 0}, 2, NodeLocation::corner}}},
               {ChangeKind::feature,
                "a fillet below the feature size forces it",
                {{{0.75, 0.5}, 5, NodeLocation::inside}},
                {{{1, 0.5}, 3, NodeLocation::boundary}}}};
  c.certificate.elements = 4;
  c.certificate.cells_examined = 20;
  c.certificate.cells_excluded = 13;
  c.certificate.cells_isolated = 1;
  c.certificate.cells_left_to_corners = 1;
  c.certificate.greatest_depth = 2;
  c.certificate.cells = {{1, {0.75, 0.25, 1, 0.5, 0.75, 0.75}, CellVerdict::zero},
                         {3, {0.25, 0.25, 0.375, 0.5, 0.125, 0.5}, CellVerdict::open},
                         {3, {0.25, 0.75, 0.125, 0.5, 0.375, 0.5}, CellVerdict::open}};
  c.certificate.disc_centres = {{0, 0}};
  c.certificate.disc_radii = {0.0625};
  return c;
}

/// The square with one node of valence 3 in the middle and a corner of valence 2 (s is invented: 0).
inline Field phase_field() {
  Field f = field();
  f.kind = FieldKind::phase;
  f.u.clear();
  f.v.clear();
  f.elem_sensor.clear();
  f.elem_error.clear();
  f.adapt_steps.clear();
  f.phase.prescribed.nodes = {{{0.5, 0.375}, 3}};
  for (int k = 0; k < 4; ++k) f.phase.prescribed.corners.push_back({k, k == 0 ? 2 : 1});
  f.phase.terms.nodes = {{{0.5, 0.375}, 1}};
  f.phase.terms.images = {{{0.5, -0.375}, 1}};
  f.phase.terms.corner_angles = {{{0, 0}, {-1, -1}, -4}};
  f.phase.s.assign(15, 0.0);
  return f;
}

/// Two blocks, cut by one line from the middle of the lower side to the middle of the upper one.
inline SeparatrixGraph separatrix_graph() {
  SeparatrixGraph g;
  g.provenance = provenance();
  g.face = face();
  g.splines = {line({0.5, 0}, {0.5, 1})};
  const Vec2 p[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int k = 0; k < 4; ++k) g.nodes.push_back({p[k], NodeKind::corner, 1, k, 0});
  g.nodes.push_back({{0.5, 0}, NodeKind::boundary, 2, 0, 0.5});
  g.nodes.push_back({{0.5, 1}, NodeKind::boundary, 2, 2, 0.5});
  g.arcs = {{0, 4, true, 0, {{0, 0, 0.5}}}, {4, 1, true, 0, {{0, 0.5, 1}}}, {1, 2, true, 0, {{1, 0, 1}}},
            {2, 5, true, 0, {{2, 0, 0.5}}}, {5, 3, true, 0, {{2, 0.5, 1}}}, {3, 0, true, 0, {{3, 0, 1}}},
            {4, 5, false, 0, {{4, 0, 1}}}};
  g.lines = {{4, 5, LineKind::cut, {6}}};
  g.certificate.method = LayoutMethod::traced;
  g.certificate.index_sum = 4;
  g.certificate.face_valence_histogram = {{4, 2}};
  return g;
}

inline BlockLayout block_layout() {
  const SeparatrixGraph g = separatrix_graph();
  BlockLayout b;
  b.provenance = provenance();
  b.face = g.face;
  b.splines = g.splines;
  b.nodes = g.nodes;
  b.arcs = g.arcs;
  b.block2nodes = {{0, 4, 5, 3}, {4, 1, 2, 5}};
  b.block2arcs = {block_sides({0, 6, 4, 5}), block_sides({1, 2, 3, -7})};
  b.arc_chord = {0, 1, 2, 1, 0, 2, 2};
  b.block_jacobian_bound = {0.125, 0.125};
  b.block_scaled_jacobian = {1, 1};
  b.block_boundary_distance = {0, 0};
  b.block_names = {"block-0", "block-1"};
  return b;
}

/// Two order-1 quads side by side.
inline QuadMesh quad_mesh() {
  QuadMesh m;
  m.provenance = provenance();
  m.face = face();
  m.order = 1;
  m.nodes = {{0, 0}, {0.5, 0}, {1, 0}, {0, 1}, {0.5, 1}, {1, 1}};
  m.elem_nodes = {0, 1, 3, 4, 1, 2, 4, 5};
  m.elem_block = {0, 1};
  m.elem_jacobian_bound = {0.125, 0.125};
  m.elem_scaled_jacobian = {1, 1};
  m.elem_edge_ratio = {2, 2};
  m.elem_area_jump = {1, 1};
  m.elem_node_distance = {0.5, 0.5};
  m.elem_prescribed_length = {0.5, 0.5};
  m.boundary_edges = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {1, 2, 2}, {0, 2, 2}, {0, 3, 3}};
  m.block_names = {"block-0", "block-1"};
  m.least_jacobian_bound = 0.125;
  return m;
}

/// The two quads, 0.5 high in one layer, with periodic ends.
inline HexMesh hex_mesh() {
  HexMesh m;
  m.provenance = provenance();
  m.length_unit = "metre";
  m.diameter = 1.5;
  m.num_quads = 2;
  for (const double z : {0.0, 0.5})
    for (const Vec2 x : quad_mesh().nodes) m.nodes.push_back({x.x, x.y, z});
  m.elem_nodes = {0, 1, 3, 4, 6, 7, 9, 10, 1, 2, 4, 5, 7, 8, 10, 11};
  m.quad_block = {0, 1};
  m.block_region = {0, 0};
  m.region_names = {"domain"};
  m.face_groups = {{"wall", {0, 1}, {0, 0}}, {"right", {1}, {1}},        {"top side", {1, 0}, {2, 2}},
                   {"left", {0}, {3}},       {"bottom", {0, 1}, {4, 4}}, {"top", {0, 1}, {5, 5}}};
  m.face_groups[4].periodic_with = 5;
  m.face_groups[4].motion.shift = {0, 0, 0.5};
  m.elem_jacobian_bound = {0.03125, 0.03125};
  m.elem_scaled_jacobian = {1, 1};
  m.least_jacobian_bound = 0.03125;
  return m;
}

}  // namespace quadrille::samples
