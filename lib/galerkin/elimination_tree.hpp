#pragma once
// Nested dissection of a triangle mesh (George 1973): halves of halves, as long as they can be cut.
//
// Unknowns that both halves of a part share are eliminated with the part, after all that lie inside the halves. It
// keeps the fill of a Cholesky factorisation near n log n, and gives it dense pieces and independent subtrees to work
// on.

#include <vector>

#include "mesh/tri_topology.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::galerkin {

struct EliminationTree {
  /// A part of the mesh: elements[begin..end).
  struct Node {
    int begin = 0, end = 0;
    int first = -1, second = -1;  ///< nodes of the halves; -1: a leaf
    int parent = -1;              ///< -1: the whole mesh
  };
  std::vector<Node> nodes;    ///< halves before the whole: the root is the last one
  std::vector<int> elements;  ///< all elements, part by part

  /// Vertices (numbers from 0) and edges (after the vertices) in a sequence of elimination.
  std::vector<int> sequence;
};

/// Cuts by straight lines in four directions, each time where the fewest edges are cut and both halves have a fair
/// share. It serves every order map of the mesh. n log n.
EliminationTree nested_dissection(const TriMesh& mesh, const mesh::TriTopology& topology);

}  // namespace quadrille::galerkin
