#include "galerkin/assemble.hpp"

namespace quadrille {

CondensedSystem assemble(const DofMap& map, const std::vector<CondensedElement>& elements,
                         const Eigen::MatrixX2d& given) {
  const int num_elems = static_cast<int>(elements.size());
  std::vector<Eigen::Triplet<double>> entries;
  std::size_t count = 0;
  for (const CondensedElement& element : elements) count += element.schur.size();
  entries.reserve(count / 2 + count / 8);
  CondensedSystem system;
  system.rhs = Eigen::MatrixX2d::Zero(map.num_unknowns, 2);
  for (int e = 0; e < num_elems; ++e) {
    const int offset = map.elem2offset[e], n = map.elem2offset[e + 1] - offset;
    const int* dofs = &map.elem2dofs[offset];
    const double* signs = &map.elem2signs[offset];
    for (int j = 0; j < n; ++j) {
      if (dofs[j] < 0) continue;
      for (int i = 0; i < n; ++i) {
        if (dofs[i] < 0 || dofs[i] >= map.num_unknowns) continue;
        const double value = signs[i] * signs[j] * elements[e].schur(i, j);
        if (dofs[j] >= map.num_unknowns) {
          system.rhs.row(dofs[i]) -= value * given.row(dofs[j] - map.num_unknowns);
        } else if (dofs[i] >= dofs[j]) {
          entries.emplace_back(dofs[i], dofs[j], value);
        }
      }
    }
  }
  system.matrix.resize(map.num_unknowns, map.num_unknowns);
  system.matrix.setFromTriplets(entries.begin(), entries.end());
  return system;
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

double relative_residual(const CondensedSystem& system, const Eigen::MatrixX2d& x) {
  if (x.rows() == 0) return 0;
  const Eigen::MatrixX2d residual = system.rhs - system.matrix.selfadjointView<Eigen::Lower>() * x;
  const double scale = system.rhs.norm();
  return scale > 0 ? residual.norm() / scale : residual.norm();
}

}  // namespace quadrille
