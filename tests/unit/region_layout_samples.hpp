#pragma once
// Small valid graphs, layouts and meshes of two regions for the tests of io and check: one block in each of the squares
// of region_samples.hpp.

#include "region_samples.hpp"

namespace quadrille::samples {

/// Arc 1 is the interface, on curve 1.
inline SeparatrixGraph two_regions_graph() {
  SeparatrixGraph g;
  g.provenance = provenance();
  g.face = two_regions_face();
  g.nodes = {{{0, 0}, NodeKind::corner, 1, 0, 0}, {{1, 0}, NodeKind::corner, 2, 4, 0},
             {{1, 1}, NodeKind::corner, 2, 2, 0}, {{0, 1}, NodeKind::corner, 1, 3, 0},
             {{2, 0}, NodeKind::corner, 1, 5, 0}, {{2, 1}, NodeKind::corner, 1, 6, 0}};
  g.arcs = {{0, 1, true, 0, {{0, 0, 1}}}, {1, 2, false, 0, {{1, 0, 1}}}, {2, 3, true, 0, {{2, 0, 1}}},
            {3, 0, true, 0, {{3, 0, 1}}}, {1, 4, true, 0, {{4, 0, 1}}},  {4, 5, true, 0, {{5, 0, 1}}},
            {5, 2, true, 0, {{6, 0, 1}}}};
  g.certificate.method = LayoutMethod::quantized;
  g.certificate.index_sum = 4;
  g.certificate.face_valence_histogram = {{4, 2}};
  return g;
}

inline BlockLayout two_regions_layout() {
  const SeparatrixGraph g = two_regions_graph();
  BlockLayout b;
  static_cast<ArcGraph&>(b) = g;
  b.provenance = g.provenance;
  b.block2nodes = {{0, 1, 2, 3}, {1, 4, 5, 2}};
  b.block2arcs = {block_sides({0, 1, 2, 3}), block_sides({4, 5, 6, -2})};
  b.arc_chord = {0, 1, 0, 1, 2, 1, 2};
  b.block_jacobian_bound = {0.25, 0.25};
  b.block_scaled_jacobian = {1, 1};
  b.block_boundary_distance = {0, 0};
  b.block_names = {"fluid", "solid"};
  b.block_region = {0, 1};
  return b;
}

/// One quad of order 1 in each block.
inline QuadMesh two_regions_quads() {
  QuadMesh m;
  m.provenance = provenance();
  m.face = two_regions_face();
  m.order = 1;
  m.nodes = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {2, 1}};
  m.elem_nodes = {0, 1, 3, 2, 1, 4, 2, 5};
  m.elem_block = {0, 1};
  m.elem_jacobian_bound = {0.25, 0.25};
  m.elem_scaled_jacobian = {1, 1};
  m.elem_edge_ratio = {1, 1};
  m.elem_area_jump = {1, 1};
  m.elem_node_distance = {1, 1};
  m.boundary_edges = {{0, 0, 0}, {0, 2, 2}, {0, 3, 3}, {1, 0, 4}, {1, 1, 5}, {1, 2, 6}};
  m.interface_edges = {{0, 1, 1}, {1, 3, 7}};
  m.block_names = {"fluid", "solid"};
  m.block_region = {0, 1};
  m.least_jacobian_bound = 0.25;
  return m;
}

/// The interface is open: its sides have nodes of their own in the same places.
inline BlockLayout open_regions_layout() {
  BlockLayout b = two_regions_layout();
  b.open_curves = {1, 7};
  b.nodes[1] = {{1, 0}, NodeKind::corner, 1, 1, 0};
  b.nodes[2] = {{1, 1}, NodeKind::corner, 1, 2, 0};
  b.nodes.push_back({{1, 0}, NodeKind::corner, 1, 4, 0});
  b.nodes.push_back({{1, 1}, NodeKind::corner, 1, 7, 0});
  b.arcs[1].is_boundary = true;
  b.arcs[4].from = 6;
  b.arcs[6].to = 7;
  b.arcs.push_back({7, 6, true, 0, {{7, 0, 1}}});
  b.block2nodes[1] = {6, 4, 5, 7};
  b.block2arcs[1] = block_sides({4, 5, 6, 7});
  b.arc_chord = {0, 1, 0, 1, 2, 3, 2, 3};
  return b;
}

inline QuadMesh open_regions_quads() {
  QuadMesh m = two_regions_quads();
  m.open_curves = {1, 7};
  m.nodes.push_back({1, 0});
  m.nodes.push_back({1, 1});
  m.elem_nodes = {0, 1, 3, 2, 6, 4, 7, 5};
  m.boundary_edges = {{0, 0, 0}, {0, 1, 1}, {0, 2, 2}, {0, 3, 3}, {1, 0, 4}, {1, 1, 5}, {1, 2, 6}, {1, 3, 7}};
  m.interface_edges.clear();
  return m;
}

}  // namespace quadrille::samples
