#pragma once
// A row of quads whose left and right sides are periodic, small enough to write its files by hand.

#include "export/exported.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// [0, n] x [0, 1] as n unit squares of order 1. Curves: below "low", right "right", above "high", left "left"; the
/// left one moved by (n, 0) is the right one.
inline QuadMesh periodic_row(int n) {
  QuadMesh mesh;
  mesh.order = 1;
  mesh.face.diameter = n;
  mesh.face.curves.resize(4);
  mesh.face.curve_names = {"low", "right", "high", "left"};
  mesh.face.periodic_pairs = {{{3, 1}, 0, {1.0 * n, 0}}};
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i <= n; ++i) mesh.nodes.push_back({1.0 * i, 1.0 * j});
  for (int e = 0; e < n; ++e) {
    for (const int node : {e, e + 1, n + 1 + e, n + 2 + e}) mesh.elem_nodes.push_back(node);
    mesh.elem_block.push_back(0);
    mesh.elem_jacobian_bound.push_back(0.25);
    mesh.elem_scaled_jacobian.push_back(1);
    mesh.boundary_edges.push_back({e, 0, 0});
  }
  mesh.block_names = {"gas"};
  mesh.boundary_edges.push_back({n - 1, 1, 1});
  for (int e = n - 1; e >= 0; --e) mesh.boundary_edges.push_back({e, 2, 2});
  mesh.boundary_edges.push_back({0, 3, 3});
  return mesh;
}

}  // namespace quadrille::exports
