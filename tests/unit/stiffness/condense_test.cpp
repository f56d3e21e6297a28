#include "stiffness/condense.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "spectral/modified_basis.hpp"
#include "stiffness/element_matrices.hpp"

namespace quadrille::stiffness {
namespace {

TEST(SymmetricMatrix, IsMadeFromTheLowerTriangle) {
  Eigen::MatrixXd all(3, 3), lower(3, 3);
  all << 1, 2, 4, 2, 3, 5, 4, 5, 6;
  lower << 1, 7, 7, 2, 3, 7, 4, 5, 6;
  EXPECT_EQ(SymmetricMatrix(lower).dense(), all);
  EXPECT_EQ(SymmetricMatrix(lower).rows(), 3);
}

TEST(SymmetricMatrix, CanBeEmpty) { EXPECT_EQ(SymmetricMatrix().dense().size(), 0); }

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
