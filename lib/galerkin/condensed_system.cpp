#include "galerkin/condensed_system.hpp"

#include <algorithm>

namespace quadrille::galerkin {

namespace {

// Adds `local`, one row per boundary mode of the element, to the rows of the free dofs in `sum`.
void add_to_free(const DofMap& map, int elem, const Eigen::MatrixXd& local, Eigen::MatrixXd& sum) {
  const int offset = map.elem2offset[elem];
  for (int i = 0; i < local.rows(); ++i) {
    const int dof = map.elem2dofs[offset + i];
    if (dof >= 0 && dof < map.num_unknowns) sum.row(dof) += map.elem2signs[offset + i] * local.row(i);
  }
}

bool has_given_dofs(const DofMap& map, int elem) {
  return std::any_of(&map.elem2dofs[map.elem2offset[elem]], map.elem2dofs.data() + map.elem2offset[elem + 1],
                     [&](int dof) { return dof >= map.num_unknowns; });
}

}  // namespace

Eigen::MatrixXd right_hand_side(const DofMap& map, const CondensedElements& elements, const Eigen::MatrixXd& given) {
  Eigen::MatrixXd dofs = Eigen::MatrixXd::Zero(map.num_dofs, given.cols()),
                  rhs = Eigen::MatrixXd::Zero(map.num_unknowns, given.cols());
  dofs.bottomRows(given.rows()) = -given;
  for (int e = 0; e < static_cast<int>(elements.size()); ++e) {
    if (has_given_dofs(map, e)) add_to_free(map, e, elements[e]->schur * element_dofs(map, e, dofs), rhs);
  }
  return rhs;
}

Eigen::MatrixXd element_dofs(const DofMap& map, int elem, const Eigen::MatrixXd& dofs) {
  const int offset = map.elem2offset[elem], n = map.elem2offset[elem + 1] - offset;
  Eigen::MatrixXd local = Eigen::MatrixXd::Zero(n, dofs.cols());
  for (int i = 0; i < n; ++i) {
    const int dof = map.elem2dofs[offset + i];
    if (dof >= 0) local.row(i) = map.elem2signs[offset + i] * dofs.row(dof);
  }
  return local;
}

Eigen::MatrixXd reactions(const DofMap& map, const CondensedElements& elements, const Eigen::MatrixXd& dofs) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(map.num_dofs - map.num_unknowns, dofs.cols());
  for (int e = 0; e < static_cast<int>(elements.size()); ++e) {
    if (!has_given_dofs(map, e)) continue;
    const Eigen::MatrixXd local = elements[e]->schur * element_dofs(map, e, dofs);
    const int offset = map.elem2offset[e];
    for (int i = 0; i < local.rows(); ++i) {
      const int given = map.elem2dofs[offset + i] - map.num_unknowns;
      if (given >= 0) sum.row(given) += map.elem2signs[offset + i] * local.row(i);
    }
  }
  return sum;
}

double relative_residual(const DofMap& map, const CondensedElements& elements, const Eigen::MatrixXd& rhs,
                         const Eigen::MatrixXd& dofs) {
  // Applies the matrix to all dofs: the reactions of the given ones form the right-hand side.
  Eigen::MatrixXd residual = Eigen::MatrixXd::Zero(map.num_unknowns, dofs.cols());
  for (int e = 0; e < static_cast<int>(elements.size()); ++e)
    add_to_free(map, e, elements[e]->schur * element_dofs(map, e, dofs), residual);
  const double scale = rhs.norm();
  return scale > 0 ? residual.norm() / scale : residual.norm();
}

}  // namespace quadrille::galerkin
