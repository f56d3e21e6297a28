#include "stiffness/condense.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "spectral/modified_basis.hpp"
#include "stiffness/element_matrices.hpp"

namespace quadrille::stiffness {
namespace {

const spectral::TriMap triangle(std::array<Vec2, 3>{Vec2{0, 0}, Vec2{1, 0.1}, Vec2{0.2, 0.9}});

TEST(Condense, SolvesLikeTheWholeMatrix) {
  // Interior rows are met, and the boundary rows give the complement's product.
  for (const int order : {3, 5, 10}) {
    const int nb = spectral::num_boundary_modes(order), ni = spectral::num_interior_modes(order);
    const Eigen::MatrixXd k = stiffness_matrix(triangle, order);
    const CondensedElement element = condense(order, k);
    Eigen::VectorXd boundary(nb);
    for (int i = 0; i < nb; ++i) boundary[i] = 1.0 / (1 + i);
    Eigen::VectorXd all(nb + ni);
    all << boundary, *element.interior * boundary;
    const Eigen::VectorXd product = k * all;
    EXPECT_LT(product.tail(ni).norm(), 1e-12);
    EXPECT_LT((product.head(nb) - element.schur.dense() * boundary).norm(), 1e-12);
  }
}

TEST(Condense, LeavesElementsWithoutInteriorModesAlone) {
  const Eigen::MatrixXd k = stiffness_matrix(triangle, 2);
  EXPECT_EQ(condense(2, k).schur.dense(), k);
  EXPECT_EQ(condense(2, k).interior->rows(), 0);
}

TEST(Condense, RefusesAMatrixThatIsNotPositiveDefinite) {
  EXPECT_THROW(condense(4, -stiffness_matrix(triangle, 4)), ComputeError);
}

}  // namespace
}  // namespace quadrille::stiffness
