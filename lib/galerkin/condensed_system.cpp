#include "galerkin/condensed_system.hpp"

#include <algorithm>

namespace quadrille {

namespace {

// Adds `local`, over the element's own modes, to the free dofs' rows of `sum`.
void add_to_free(const DofMap& map, int elem, const Eigen::MatrixX2d& local, Eigen::MatrixX2d& sum) {
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

Eigen::MatrixX2d right_hand_side(const DofMap& map, const std::vector<CondensedElement>& elements,
                                 const Eigen::MatrixX2d& given) {
  Eigen::MatrixX2d dofs = Eigen::MatrixX2d::Zero(map.num_dofs, 2), rhs = Eigen::MatrixX2d::Zero(map.num_unknowns, 2);
  dofs.bottomRows(given.rows()) = -given;
  for (int e = 0; e < static_cast<int>(elements.size()); ++e) {
    if (has_given_dofs(map, e)) add_to_free(map, e, elements[e].schur * element_dofs(map, e, dofs), rhs);
  }
  return rhs;
}

Eigen::MatrixX2d element_dofs(const DofMap& map, int elem, const Eigen::MatrixX2d& dofs) {
  const int offset = map.elem2offset[elem], n = map.elem2offset[elem + 1] - offset;
  Eigen::MatrixX2d local = Eigen::MatrixX2d::Zero(n, 2);
  for (int i = 0; i < n; ++i) {
    const int dof = map.elem2dofs[offset + i];
    if (dof >= 0) local.row(i) = map.elem2signs[offset + i] * dofs.row(dof);
  }
  return local;
}

double relative_residual(const DofMap& map, const std::vector<CondensedElement>& elements, const Eigen::MatrixX2d& rhs,
                         const Eigen::MatrixX2d& dofs) {
  // All dofs at once: the given ones' reactions are the right-hand side.
  Eigen::MatrixX2d residual = Eigen::MatrixX2d::Zero(map.num_unknowns, 2);
  for (int e = 0; e < static_cast<int>(elements.size()); ++e)
    add_to_free(map, e, elements[e].schur * element_dofs(map, e, dofs), residual);
  const double scale = rhs.norm();
  return scale > 0 ? residual.norm() / scale : residual.norm();
}

}  // namespace quadrille
