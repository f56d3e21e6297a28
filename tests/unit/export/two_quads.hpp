#pragma once
// A mesh of two quads of order 2, small enough to write its files by hand.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "../support/test_data.hpp"
#include "export/exported.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// [0, 2]^2 and [2, 4] x [0, 2], the second with a curved top through (3, 2.5) and, in its middle, the blend of its
/// sides. Nodes row by row from below. Curves: below and above "wall", right "in & out", left without a name.
inline QuadMesh two_quads() {
  QuadMesh mesh;
  mesh.order = 2;
  mesh.face.diameter = 5;
  mesh.face.curves.resize(4);
  mesh.face.curve_names = {"wall", "in & out", "wall", ""};
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 5; ++i) mesh.nodes.push_back({1.0 * i, 1.0 * j});
  mesh.nodes[8].y = 1.25;
  mesh.nodes[13].y = 2.5;
  for (const int first : {0, 2})
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) mesh.elem_nodes.push_back(first + 5 * j + i);
  mesh.elem_block = {0, 1};
  mesh.block_names = {"left", "right"};
  mesh.elem_jacobian_bound = mesh.elem_scaled_jacobian = {0.5, 0.5};
  mesh.boundary_edges = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {1, 2, 2}, {0, 2, 2}, {0, 3, 3}};
  return mesh;
}

/// The same with an interface between the quads: curve 4, and 5 from the other side.
inline QuadMesh with_interface_called(const std::string& name) {
  QuadMesh mesh = two_quads();
  mesh.face.curves.resize(6);
  mesh.face.curve_names.insert(mesh.face.curve_names.end(), 2, name);
  mesh.face.partners = {-1, -1, -1, -1, 5, 4};
  mesh.interface_edges = {{0, 1, 4}, {1, 3, 5}};
  return mesh;
}

/// The same with the names that the pages in formats/export give it.
inline QuadMesh two_quads_of_the_pages() {
  QuadMesh mesh = two_quads();
  mesh.face.curve_names = {"wall", "outlet", "wall", "wall"};
  mesh.block_names = {"fluid", "fluid"};
  return mesh;
}

/// A page of formats/export.
inline std::string page(const std::string& name) {
  std::ifstream file(test_data() + "/../../formats/export/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The same with the middle of the second quad moved, which its sides do not tell.
inline QuadMesh two_quads_with_moved_middle() {
  QuadMesh mesh = two_quads();
  mesh.nodes[8] = {3.125, 1.5};
  return mesh;
}

/// Its corners alone.
inline QuadMesh two_straight_quads() {
  QuadMesh mesh = two_quads();
  mesh.order = 1;
  mesh.nodes = {{0, 0}, {2, 0}, {4, 0}, {0, 2}, {2, 2}, {4, 2}};
  mesh.elem_nodes = {0, 1, 3, 4, 1, 2, 4, 5};
  return mesh;
}

/// Two quads of order 2 around a hole, both between the same four vertices (1, 0), (2, 0), (-2, 0), (-1, 0).
inline QuadMesh ring_of_two_quads() {
  QuadMesh mesh = two_quads();
  mesh.nodes.clear();
  for (const Vec2 direction : {Vec2{1, 0}, {0, 1}, {-1, 0}, {0, -1}})
    for (const double radius : {1.0, 1.5, 2.0}) mesh.nodes.push_back(radius * direction);
  mesh.elem_nodes = {0, 1, 2, 3, 4, 5, 6, 7, 8, 6, 7, 8, 9, 10, 11, 0, 1, 2};
  mesh.boundary_edges = {{0, 1, 0}, {1, 1, 1}, {1, 3, 2}, {0, 3, 3}};
  return mesh;
}

/// A test of two_quads() and of the model that an exporter makes of it before it writes.
template <auto make_model>
struct TwoQuadsTest : testing::Test {
  QuadMesh mesh = two_quads();
  decltype(make_model(mesh, Frame())) model = make_model(mesh, plane_frame(mesh.face));
};

/// x3d = (7, 0, 0) + x (0, 1, 0) + y (0, 0, 1).
inline Frame upright_frame() { return {{7, 0, 0}, {0, 1, 0}, {0, 0, 1}}; }

}  // namespace quadrille::exports
