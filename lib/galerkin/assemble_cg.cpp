#include "galerkin/assemble_cg.hpp"

namespace quadrille {

CgSystem assemble_cg(const DofMap& map, const std::vector<CondensedElement>& elements, const Eigen::MatrixX2d& given) {
  const int num_elems = static_cast<int>(elements.size());
  std::vector<Eigen::Triplet<double>> entries;
  std::size_t count = 0;
  for (const CondensedElement& element : elements) count += element.schur.size();
  entries.reserve(count / 2 + count / 8);
  CgSystem system;
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

}  // namespace quadrille
