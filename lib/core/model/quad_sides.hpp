#pragma once
// The nodes on the sides of a quad mesh's elements. Side k (0 to 3) runs counter-clockwise from corner k to corner k
// + 1.

#include <array>
#include <vector>

#include "model/quad_mesh.hpp"

namespace quadrille {

/// Where node k (0 to N) of a side stands among the (N + 1)^2 nodes of its element.
inline int local_side_node(int order, int side, int k) {
  const int width = order + 1;
  const std::array<int, 4> starts{0, order, width * width - 1, width * order}, strides{1, width, -1, -width};
  return starts[side] + k * strides[side];
}

/// Node k (0 to N) of a side of an element.
inline int side_node(const QuadMesh& mesh, int elem, int side, int k) {
  return mesh.elem_nodes[elem * mesh.nodes_per_elem() + local_side_node(mesh.order, side, k)];
}

/// The node at the corner where the side starts.
inline int side_start(const QuadMesh& mesh, int elem, int side) { return side_node(mesh, elem, side, 0); }

/// The N + 1 nodes of a side, both ends included.
inline std::vector<int> side_nodes(const QuadMesh& mesh, int elem, int side) {
  std::vector<int> nodes;
  for (int k = 0; k <= mesh.order; ++k) nodes.push_back(side_node(mesh, elem, side, k));
  return nodes;
}

}  // namespace quadrille
