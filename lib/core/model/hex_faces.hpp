#pragma once
// The faces of the elements of a hexahedral mesh, sorted so that those that two elements share are neighbours.

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <vector>

#include "model/hex_mesh.hpp"

namespace quadrille {

/// A face of an element, with the numbers of its corners in ascending order as the sort key.
struct HexFace {
  std::array<int, 4> corners{};
  int elem = 0, face = 0;
  auto operator<=>(const HexFace&) const = default;
};

/// The faces of all elements, sorted: those that two elements share are neighbours.
inline std::vector<HexFace> sorted_hex_faces(const HexMesh& mesh) {
  const int n = mesh.order, width = n + 1;
  std::vector<HexFace> faces;
  faces.reserve(6 * static_cast<std::size_t>(mesh.num_elems()));
  std::array<std::vector<int>, 6> local;
  for (int face = 0; face < 6; ++face) local[face] = hex_face_nodes(n, face);
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const int* const nodes = &mesh.elem_nodes[static_cast<std::size_t>(elem) * mesh.nodes_per_elem()];
    for (int face = 0; face < 6; ++face) {
      const auto node = [&](int k) { return nodes[local[face][k]]; };
      HexFace own{{node(0), node(n), node(width * n), node(width * width - 1)}, elem, face};
      std::sort(own.corners.begin(), own.corners.end());
      faces.push_back(own);
    }
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace quadrille
