#pragma once
// Nested dissection of a triangle mesh (George 1973): the mesh is bisected recursively as long as parts can be cut.
//
// Unknowns shared by both halves of a part are eliminated with the part, after all unknowns inside the halves. The fill
// of a Cholesky factorisation is then near n log n, and the factorisation works on dense blocks and independent
// subtrees.

#include <vector>

#include "mesh/tri_topology.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::mesh {

struct EliminationTree {
  /// A part of the mesh: elements[begin..end).
  struct Node {
    int begin = 0, end = 0;
    int first = -1, second = -1;  ///< nodes of the halves; -1: a leaf
    int parent = -1;              ///< -1: the whole mesh
  };
  std::vector<Node> nodes;    ///< children before their parent: the root is the last one
  std::vector<int> elements;  ///< all elements, part by part

  /// Elimination order of vertices (numbers from 0) and edges (numbers after the vertices).
  std::vector<int> elimination_order;
};

/// Cuts by straight lines in four directions, each time where the fewest edges are cut and both halves are of
/// comparable size. The tree is valid for every order map of the mesh. Cost: n log n.
EliminationTree nested_dissection(const TriMesh& mesh, const TriTopology& topology);

}  // namespace quadrille::mesh
