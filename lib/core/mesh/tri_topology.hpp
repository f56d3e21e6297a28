#pragma once
// Adjacency of a triangle mesh. Index base 0, -1 = none.

#include <array>
#include <vector>

#include "model/tri_mesh.hpp"

namespace quadrille::mesh {

struct TriTopology {
  std::vector<std::array<int, 2>> edge2vertices;        ///< lower vertex first; sorted
  std::vector<std::array<int, 2>> edge2elems;           ///< second is -1 on the boundary
  std::vector<std::array<int, 3>> elem2edges;           ///< by local edge
  std::vector<std::array<int, 3>> elem2neighbors;       ///< by local edge
  std::vector<std::array<int, 3>> elem2neighbor_edges;  ///< the neighbour's local edge
  std::vector<std::array<int, 3>> elem2boundary_edge;   ///< index into mesh.boundary_edges or -1
};

/// Throws FormatError if three elements share an edge, if two have the same direction along an edge, or if the boundary
/// edges of the mesh are not exactly the edges with one element.
TriTopology tri_topology(const TriMesh& mesh);

}  // namespace quadrille::mesh
