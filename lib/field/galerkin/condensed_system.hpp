#pragma once
// The global system of the condensed elements, evaluated element by element: the sum K of their Schur complements over
// the free dofs, and the right-hand side from the given (boundary) dofs. Each column of a matrix is one function.
//
// Global numbering of vertex and edge modes (Karniadakis and Sherwin, sec. 4.2), minimum rule on edges.
//
// An edge between elements of orders P_a, P_b has the modes of degree 2..min(P_a, P_b); it is directed from the lower
// to the higher vertex number. Numbers [0, num_unknowns) are free, [num_unknowns, num_dofs) lie on the boundary, where
// the values are given. Interior modes are condensed and have no number.

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <vector>

#include "mesh/tri_topology.hpp"
#include "model/tri_mesh.hpp"
#include "stiffness/element_matrices.hpp"

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

/// The same with other given dofs than those on the boundary: of the entities (vertices, then edges) with `is_given`.
DofMap make_dof_map(const TriMesh& mesh, const mesh::TriTopology& topology, const std::vector<int>& elimination_order,
                    const std::vector<int>& elem_order, const std::vector<bool>& is_given);

/// Numbers of the trace unknowns of the hybridised method: edge modes of degree 0..order, where order is the greater
/// one of both elements (edge2order); vertices have none. Free edges are numbered in elimination order, then the
/// boundary edges.
DofMap make_trace_map(const TriMesh& mesh, const mesh::TriTopology& topology, const std::vector<int>& elimination_order,
                      const std::vector<int>& elem_order);

using stiffness::CondensedElement;
using stiffness::CondensedElements;

/// The right-hand side, num_unknowns rows: minus the reactions of `given`, the values of the dofs [num_unknowns,
/// num_dofs).
Eigen::MatrixXd right_hand_side(const DofMap& map, const CondensedElements& elements, const Eigen::MatrixXd& given);

/// Many functions with few values each, one per column; stored by row.
using SparseColumns = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Given values as the system receives them.
struct SparseData {
  SparseColumns rhs;        ///< as right_hand_side()
  Eigen::MatrixXd product;  ///< the energy products of the functions that are 0 in all free dofs
};
SparseData sparse_data(const DofMap& map, const CondensedElements& elements, const SparseColumns& given);

/// The coefficients of the boundary modes of one element; 0 for modes without a dof.
Eigen::MatrixXd element_dofs(const DofMap& map, int elem, const Eigen::MatrixXd& dofs);

/// The rows of the given dofs of the full matrix, multiplied by `dofs` (all dofs). If the free dofs solve the system,
/// the energy product a(f, g) of two columns is (given part of f) . (reaction of g).
Eigen::MatrixXd reactions(const DofMap& map, const CondensedElements& elements, const Eigen::MatrixXd& dofs);

/// |rhs - K x| / |rhs|; |rhs - K x| if the right-hand side is 0. `rhs`: of the given dofs, and `load` if there is any;
/// `dofs`: all, x, then the given ones.
double relative_residual(const DofMap& map, const CondensedElements& elements, const Eigen::MatrixXd& rhs,
                         const Eigen::MatrixXd& dofs, const Eigen::MatrixXd& load = {});

}  // namespace quadrille::galerkin
