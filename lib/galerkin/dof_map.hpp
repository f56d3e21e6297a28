#pragma once
// Global numbers of vertex and edge modes (Karniadakis and Sherwin, sec. 4.2), minimum rule on edges.
//
// An edge between elements of orders P_a, P_b has the modes of degree 2..min(P_a, P_b); its own direction runs from the
// lower to the higher vertex. Numbers [0, num_unknowns) are free, [num_unknowns, num_dofs) lie on the boundary, where
// the values are given. Interior modes have no number: they are condensed away.

#include <vector>

#include "mesh/tri_topology.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::galerkin {

struct DofMap {
  int num_unknowns = 0, num_dofs = 0;
  std::vector<int> vertex2dof;
  std::vector<int> edge2dof;       ///< of its first mode (degree 2, or 0 of a trace); higher degrees follow
  std::vector<int> edge2order;     ///< the order that both elements see on it
  std::vector<int> elem2offset;    ///< element e's boundary modes are [elem2offset[e], elem2offset[e+1]) of:
  std::vector<int> elem2dofs;      ///< the dof of each boundary mode in the basis' sequence, -1: dropped by the rule
  std::vector<double> elem2signs;  ///< +1 or -1: the mode is this times the dof's shape
};

/// Free dofs are numbered along `sequence`, then those of the boundary.
DofMap make_dof_map(const TriMesh& mesh, const mesh::TriTopology& topology, const std::vector<int>& sequence,
                    const std::vector<int>& elem_order);

/// Numbers of the trace unknowns of the hybridised method: edge modes of degree 0..order, order the greater one of both
/// elements (edge2order); vertices have none. Free edges along `sequence`, then those of the boundary.
DofMap make_trace_map(const TriMesh& mesh, const mesh::TriTopology& topology, const std::vector<int>& sequence,
                      const std::vector<int>& elem_order);

}  // namespace quadrille::galerkin
