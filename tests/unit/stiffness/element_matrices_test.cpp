#include "stiffness/element_matrices.hpp"

#include <gtest/gtest.h>

#include "../test_meshes.hpp"
#include "base/error.hpp"
#include "mesh/tri_topology.hpp"
#include "spectral/modified_basis.hpp"
#include "spectral/orthogonal_basis.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::stiffness {
namespace {

const spectral::TriMap straight(std::array<Vec2, 3>{Vec2{0.2, 0.1}, Vec2{1.5, 0.4}, Vec2{0.4, 1.3}});

TEST(ElementMatrices, LinearMatrixIsTheTextbookOne) {
  // K_ij = e_i . e_j / (4 area), e_i the edge opposite vertex i.
  const Eigen::MatrixXd k = stiffness_matrix(straight, 1);
  const Vec2 e[3] = {{-1.1, 0.9}, {-0.2, -1.2}, {1.3, 0.3}};
  const double area = cross(Vec2{1.3, 0.3}, Vec2{0.2, 1.2}) / 2;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(k(i, j), dot(e[i], e[j]) / (4 * area), 1e-14);
  }
}

TEST(ElementMatrices, IsSymmetricSemidefiniteWithConstantsAsItsKernel) {
  const TriMesh disc = disc_mesh(6, 8);
  for (const spectral::TriMap& map : {straight, mesh::tri_maps(disc)[2]}) {
    for (const int order : {1, 2, 5, 12}) {
      const Eigen::MatrixXd k = stiffness_matrix(map, order);
      EXPECT_LT((k - k.transpose()).norm(), 1e-12);
      Eigen::VectorXd one = Eigen::VectorXd::Zero(k.rows());
      one.head(3).setOnes();
      EXPECT_LT((k * one).norm(), 1e-12);
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(k);
      EXPECT_GT(eigen.eigenvalues()[0], -1e-12);
      EXPECT_GT(eigen.eigenvalues()[1], 1e-12);
    }
  }
}

TEST(ElementMatrices, OfSimilarElementsAreEqual) {
  // Turned by a right angle, halved and moved.
  const auto moved = [](Vec2 x) { return Vec2{3 - x.y / 2, -2 + x.x / 2}; };
  const spectral::TriMap similar(
      {moved(straight.position({-1, -1})), moved(straight.position({1, -1})), moved(straight.position({-1, 1}))});
  EXPECT_LT((stiffness_matrix(similar, 6) - stiffness_matrix(straight, 6)).norm(), 1e-11);
}

TEST(ElementMatrices, CurvedIntegrationAgreesWithTheAffineShortCut) {
  // An affine element given as one of order 4 takes the other path.
  std::vector<Vec2> nodes;
  for (const Vec2 xi : spectral::tri_nodes(4)) nodes.push_back(straight.position(xi));
  const spectral::TriMap as_curved(4, nodes.data());
  for (const int order : {3, 8, 11}) {
    EXPECT_LT((stiffness_matrix(straight, order) - stiffness_matrix(as_curved, order)).norm(), 1e-11);
  }
}

TEST(ElementMatrices, QuadratureOfCurvedElementsHasConverged) {
  const TriMesh disc = disc_mesh(8, 8);
  const spectral::TriMap map = mesh::tri_maps(disc)[0];
  for (const int order : {4, 8, 16}) {
    const Eigen::MatrixXd fine = stiffness_matrix(map, order, 20);
    EXPECT_LT((stiffness_matrix(map, order) - fine).cwiseAbs().maxCoeff(), 1e-11);
  }
}

TEST(ElementMatrices, SumFactorisationGivesTheIntegralOfProductsOfGradients) {
  const TriMesh disc = disc_mesh(6, 8);
  const spectral::TriMap map = mesh::tri_maps(disc)[1];
  const int order = 7, num_points = order + 6, n = spectral::num_tri_modes(order);
  const spectral::Quadrature along = spectral::gauss_legendre(num_points),
                             up = spectral::gauss_jacobi(num_points, 1, 0);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(n, n), d(n, 2);
  Eigen::VectorXd values(n);
  for (int i = 0; i < num_points; ++i) {
    for (int j = 0; j < num_points; ++j) {
      const Vec2 xi{(1 + along.points[i]) * (1 - up.points[j]) / 2 - 1, up.points[j]};
      spectral::modified_gradients(order, xi, values.data(), d.col(0).data(), d.col(1).data());
      Vec2 x;
      Mat2 jacobian;
      map.evaluate(xi, x, jacobian);
      const Mat2 inverted = inverse(jacobian);
      Eigen::Matrix2d to_physical;
      to_physical << inverted.xx, inverted.xy, inverted.yx, inverted.yy;
      const Eigen::MatrixXd gradients = d * to_physical;
      expected += along.weights[i] * up.weights[j] / 2 * det(jacobian) * gradients * gradients.transpose();
    }
  }
  EXPECT_LT((stiffness_matrix(map, order) - expected).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(ElementMatrices, LowerOrdersAreCutOutOfHigherOnes) {
  EXPECT_LT((cut_down(stiffness_matrix(straight, 11), 11, 6) - stiffness_matrix(straight, 6)).norm(), 1e-12);
}

TEST(SymmetricMatrix, IsMadeFromTheLowerTriangle) {
  Eigen::MatrixXd all(3, 3), lower(3, 3);
  all << 1, 2, 4, 2, 3, 5, 4, 5, 6;
  lower << 1, 7, 7, 2, 3, 7, 4, 5, 6;
  EXPECT_EQ(SymmetricMatrix(lower).dense(), all);
  for (int i = 0; i < all.rows(); ++i)
    for (int j = 0; j < all.cols(); ++j) EXPECT_EQ(SymmetricMatrix(lower)(i, j), all(i, j));
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
