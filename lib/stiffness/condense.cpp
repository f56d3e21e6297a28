#include "stiffness/condense.hpp"

#include "base/error.hpp"

namespace quadrille::stiffness {
namespace {

constexpr const char* folded = "an element's stiffness matrix is not positive definite";

InteriorModes factored(const Eigen::MatrixXd& k_ii, const Eigen::MatrixXd& k_ib, const char* failure) {
  InteriorModes interior{k_ii, k_ib};
  if (Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>(interior.factor).info() != Eigen::Success) throw ComputeError(failure);
  return interior;
}

}  // namespace

Eigen::MatrixXd InteriorModes::of(const Eigen::MatrixXd& boundary) const {
  Eigen::MatrixXd coefs = -coupling * boundary;
  const auto lower = factor.triangularView<Eigen::Lower>();
  lower.solveInPlace(coefs);
  lower.transpose().solveInPlace(coefs);
  return coefs;
}

CondensedElement eliminate_interior(const Eigen::MatrixXd& k_ii, const Eigen::MatrixXd& k_ib,
                                    const Eigen::MatrixXd& k_bb, const char* failure) {
  CondensedElement element{k_bb, factored(k_ii, k_ib, failure), {}};
  Eigen::MatrixXd half = k_ib;  // L^-1 K_ib
  element.interior->factor.triangularView<Eigen::Lower>().solveInPlace(half);
  // K_bb - half^T half is symmetric by construction.
  element.schur.selfadjointView<Eigen::Lower>().rankUpdate(half.transpose(), -1);
  element.schur.triangularView<Eigen::StrictlyUpper>() = element.schur.transpose();
  return element;
}

CondensedElement condense(int order, const Eigen::MatrixXd& stiffness) {
  const int nb = spectral::num_boundary_modes(order), ni = spectral::num_interior_modes(order);
  return eliminate_interior(stiffness.bottomRightCorner(ni, ni), stiffness.bottomLeftCorner(ni, nb),
                            stiffness.topLeftCorner(nb, nb), folded);
}

}  // namespace quadrille::stiffness
