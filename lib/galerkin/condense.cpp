#include "galerkin/condense.hpp"

#include "base/error.hpp"
#include "spectral/modified_basis.hpp"

namespace quadrille::galerkin {

CondensedElement condense(int order, const Eigen::MatrixXd& stiffness) {
  const int nb = spectral::num_boundary_modes(order), ni = spectral::num_interior_modes(order);
  CondensedElement element;
  if (ni == 0) {
    element.schur = stiffness;
    element.interior_from_boundary.resize(0, nb);
    return element;
  }
  const Eigen::LLT<Eigen::MatrixXd> factor(stiffness.bottomRightCorner(ni, ni));
  if (factor.info() != Eigen::Success) throw ComputeError("an element's stiffness matrix is not positive definite");
  // With K_ii = L L^T and Y = L^-1 K_ib, the Schur complement is K_bb - Y^T Y: symmetric by construction.
  Eigen::MatrixXd y = stiffness.bottomLeftCorner(ni, nb);
  factor.matrixL().solveInPlace(y);
  element.schur = stiffness.topLeftCorner(nb, nb);
  element.schur.selfadjointView<Eigen::Lower>().rankUpdate(y.transpose(), -1);
  element.schur.triangularView<Eigen::StrictlyUpper>() = element.schur.transpose();
  factor.matrixU().solveInPlace(y);
  element.interior_from_boundary = -y;
  return element;
}

}  // namespace quadrille::galerkin
