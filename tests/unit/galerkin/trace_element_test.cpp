#include "galerkin/trace_element.hpp"

#include <gtest/gtest.h>

#include "spectral/orthogonal_basis.hpp"
#include "spectral/quadrature.hpp"
#include "stiffness/element_matrices.hpp"

namespace quadrille::galerkin {
namespace {

stiffness::CondensedElement sample_element(double penalty) {
  const spectral::TriMap map({Vec2{0.1, -0.2}, Vec2{1.3, 0.1}, Vec2{0.4, 0.9}});
  return condense_to_trace(map, 5, {5, 7, 6}, stiffness::stiffness_matrix(map, 5), penalty);
}

TEST(TraceElement, TraceModesAreOrthonormal) {
  const spectral::Quadrature rule = spectral::gauss_legendre(8);
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(8, 8);
  for (std::size_t q = 0; q < rule.points.size(); ++q) {
    Eigen::VectorXd values(8);
    trace_values(7, rule.points[q], values.data());
    gram += rule.weights[q] * values * values.transpose();
  }
  EXPECT_LT((gram - Eigen::MatrixXd::Identity(8, 8)).norm(), 1e-13);
}

TEST(TraceElement, AConstantTraceHasAConstantInsideAndNoFlux) {
  const stiffness::CondensedElement element = sample_element(3);
  Eigen::VectorXd trace = Eigen::VectorXd::Zero(element.schur.rows());
  for (const int first : {0, 6, 14}) trace[first] = std::sqrt(2.0);  // the value 1 on all three edges
  EXPECT_LT((element.schur.dense() * trace).norm(), 1e-11);
  const Eigen::VectorXd inside = *element.interior * trace;
  EXPECT_LT((inside.head(3) - Eigen::Vector3d::Ones()).norm(), 1e-12);
  EXPECT_LT(inside.tail(inside.size() - 3).norm(), 1e-12);
}

TEST(TraceElement, TheComplementIsSymmetricWithOneZeroEnergy) {
  const stiffness::CondensedElement element = sample_element(3);
  const Eigen::VectorXd energies = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(element.schur.dense()).eigenvalues();
  EXPECT_NEAR(energies[0], 0, 1e-11 * energies.maxCoeff());
  EXPECT_GT(energies[1], 1e-3);
}

TEST(TraceElement, TooSmallAPenaltyIsRefused) { EXPECT_ANY_THROW(sample_element(0.01)); }

}  // namespace
}  // namespace quadrille::galerkin
