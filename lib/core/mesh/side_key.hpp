#pragma once
// What elements that share a side know it by.

#include <algorithm>
#include <utility>

#include "model/quad_mesh.hpp"

namespace quadrille::mesh {

/// The nodes next to the ends of a side, the lower one first: two sides may have the same ends, as those of a ring of
/// two elements have. At order 1 the ends themselves: straight sides with the same ends are one.
inline std::pair<int, int> side_key(const QuadMesh& mesh, int elem, int side) {
  return std::minmax({side_node(mesh, elem, side, 1), side_node(mesh, elem, side, mesh.order - 1)});
}

}  // namespace quadrille::mesh
