#pragma once
// Global numbering of vertex and edge modes (Karniadakis and Sherwin, sec. 4.2), minimum rule on edges.
//
// An edge between elements of orders P_a, P_b has the modes of degree 2..min(P_a, P_b); it is directed from the lower
// to the higher vertex number. Numbers [0, num_unknowns) are free, [num_unknowns, num_dofs) lie on the boundary, where
// the values are given. Interior modes are condensed and have no number.

#include <vector>

#include "mesh/tri_topology.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::galerkin {

struct DofMap {
  int num_unknowns = 0, num_dofs = 0;
  std::vector<int> vertex2dof;
  std::vector<int> edge2dof;       ///< dof of its first mode (degree 2; 0 of a trace); higher degrees follow
  std::vector<int> edge2order;     ///< the order of the edge, common to both elements
  std::vector<int> elem2offset;    ///< boundary modes of element e: [elem2offset[e], elem2offset[e+1])
  std::vector<int> elem2dofs;      ///< the dof of each boundary mode, ordered as the basis; -1: dropped by the rule
  std::vector<double> elem2signs;  ///< +1 or -1: the mode is this times the shape function of the dof
};

/// `elimination_order`: vertices and edges as in mesh::EliminationTree. The free dofs are numbered in this order, then
/// the boundary dofs.
DofMap make_dof_map(const TriMesh& mesh, const mesh::TriTopology& topology, const std::vector<int>& elimination_order,
                    const std::vector<int>& elem_order);

/// Numbers of the trace unknowns of the hybridised method: edge modes of degree 0..order, where order is the greater
/// one of both elements (edge2order); vertices have none. Free edges are numbered in elimination order, then the
/// boundary edges.
DofMap make_trace_map(const TriMesh& mesh, const mesh::TriTopology& topology, const std::vector<int>& elimination_order,
                      const std::vector<int>& elem_order);

}  // namespace quadrille::galerkin
