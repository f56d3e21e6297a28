#include "galerkin/condense.hpp"

#include "base/error.hpp"
#include "spectral/modified_basis.hpp"

namespace quadrille::galerkin {

Eigen::MatrixXd CondensedElement::interior(const Eigen::MatrixXd& boundary) const {
  Eigen::MatrixXd coefs = half * boundary;
  factor.triangularView<Eigen::Lower>().transpose().solveInPlace(coefs);
  return -coefs;
}

CondensedElement eliminate_interior(const Eigen::MatrixXd& k_ii, const Eigen::MatrixXd& k_ib,
                                    const Eigen::MatrixXd& k_bb, const char* failure) {
  CondensedElement element{k_bb, k_ii, k_ib};
  if (Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>(element.factor).info() != Eigen::Success) throw ComputeError(failure);
  element.factor.triangularView<Eigen::Lower>().solveInPlace(element.half);
  // K_bb - half^T half is symmetric by construction.
  element.schur.selfadjointView<Eigen::Lower>().rankUpdate(element.half.transpose(), -1);
  element.schur.triangularView<Eigen::StrictlyUpper>() = element.schur.transpose();
  return element;
}

CondensedElement condense(int order, const Eigen::MatrixXd& stiffness) {
  const int nb = spectral::num_boundary_modes(order), ni = spectral::num_interior_modes(order);
  return eliminate_interior(stiffness.bottomRightCorner(ni, ni), stiffness.bottomLeftCorner(ni, nb),
                            stiffness.topLeftCorner(nb, nb), "an element's stiffness matrix is not positive definite");
}

}  // namespace quadrille::galerkin
