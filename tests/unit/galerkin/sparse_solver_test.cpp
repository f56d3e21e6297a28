#include "galerkin/sparse_solver.hpp"

#include <gtest/gtest.h>

#include "../test_meshes.hpp"
#include "base/error.hpp"
#include "galerkin/condensed_system.hpp"
#include "galerkin/discretization.hpp"
#include "stiffness/element_matrices.hpp"

namespace quadrille::galerkin {
namespace {

// A mesh, its dofs and the condensed matrices of its elements.
struct Problem {
  explicit Problem(int n, int order)
      : mesh(parallelogram_mesh({-0.4, -0.3}, {0.9, 0.2}, {-0.3, 0.8}, n)),
        context(mesh),
        map(make_dof_map(mesh, context.topology, context.tree.elimination_order,
                         std::vector<int>(mesh.num_elems(), order))) {
    for (const spectral::TriMap& map_of_elem : context.maps)
      elements.push_back(std::make_shared<CondensedElement>(
          stiffness::condense(order, stiffness::stiffness_matrix(map_of_elem, order))));
  }
  Eigen::MatrixX2d solve(const Eigen::MatrixX2d& rhs, int num_threads) const {
    const auto solver = make_sparse_solver(context.tree, map, num_threads);
    solver->factor(elements);
    return solver->solve(rhs);
  }
  TriMesh mesh;
  MeshContext context;
  DofMap map;
  CondensedElements elements;
};

// The sum of the elements' matrices over the free dofs, entry by entry.
Eigen::MatrixXd dense_matrix(const Problem& p) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(p.map.num_unknowns, p.map.num_unknowns);
  for (int e = 0; e < p.mesh.num_elems(); ++e) {
    const int offset = p.map.elem2offset[e], n = p.map.elem2offset[e + 1] - offset;
    const Eigen::MatrixXd schur = p.elements[e]->schur.dense();
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const int a = p.map.elem2dofs[offset + i], b = p.map.elem2dofs[offset + j];
        if (a < 0 || b < 0 || a >= p.map.num_unknowns || b >= p.map.num_unknowns) continue;
        sum(a, b) += p.map.elem2signs[offset + i] * p.map.elem2signs[offset + j] * schur(i, j);
      }
    }
  }
  return sum;
}

Eigen::MatrixX2d sample_rhs(int n) {
  Eigen::MatrixX2d rhs(n, 2);
  for (int i = 0; i < n; ++i) rhs.row(i) << std::sin(i + 1.0), std::cos(3.0 * i);
  return rhs;
}

TEST(CondensedCholesky, SolvesWhatADenseSolverSolves) {
  for (const int n : {1, 2, 3, 7}) {
    const Problem p(n, 4);
    const Eigen::MatrixX2d rhs = sample_rhs(p.map.num_unknowns);
    const Eigen::MatrixX2d dense = dense_matrix(p).llt().solve(rhs);
    EXPECT_LT((p.solve(rhs, 1) - dense).norm(), 1e-11 * dense.norm()) << n;
  }
}

TEST(CondensedCholesky, GivesTheSameBytesOnAnyNumberOfThreads) {
  const Problem p(14, 5);
  const Eigen::MatrixX2d rhs = sample_rhs(p.map.num_unknowns), one = p.solve(rhs, 1);
  for (const int num_threads : {2, 3, 5}) EXPECT_EQ((p.solve(rhs, num_threads) - one).cwiseAbs().maxCoeff(), 0);
}

TEST(CondensedCholesky, ProductsOfSparseColumnsAreThoseOfTheirSolutions) {
  for (const int n : {1, 3, 14}) {
    const Problem p(n, 4);
    Eigen::MatrixXd b = Eigen::MatrixXd::Zero(p.map.num_unknowns, 7);  // the columns lie in different parts
    for (int i = 0; i < b.rows(); i += 5) b(i, i * 7 / static_cast<int>(b.rows())) = std::sin(i + 1.0);
    const auto solver = make_sparse_solver(p.context.tree, p.map, 1);
    solver->factor(p.elements);
    const Eigen::MatrixXd products = b.transpose() * solver->solve(b);
    EXPECT_LT((solver->inverse_products(b.sparseView()) - products).norm(), 1e-12 * products.norm()) << n;
  }
}

TEST(CondensedCholesky, TheResidualIsThatOfTheSystem) {
  const Problem p(3, 4);
  const Eigen::MatrixX2d given = sample_rhs(p.map.num_dofs - p.map.num_unknowns);
  const Eigen::MatrixX2d rhs = right_hand_side(p.map, p.elements, given);
  Eigen::MatrixX2d dofs(p.map.num_dofs, 2);
  dofs << p.solve(rhs, 1), given;
  EXPECT_LT(relative_residual(p.map, p.elements, rhs, dofs), 1e-13);
  dofs(0, 0) += 1e-3;
  EXPECT_GT(relative_residual(p.map, p.elements, rhs, dofs), 1e-6);
}

TEST(CondensedCholesky, RefusesAnIndefiniteMatrix) {
  Problem p(3, 3);
  for (auto& element : p.elements) {
    CondensedElement negative = *element;
    negative.schur = stiffness::SymmetricMatrix(-negative.schur.dense());
    element = std::make_shared<CondensedElement>(negative);
  }
  EXPECT_THROW(p.solve(sample_rhs(p.map.num_unknowns), 1), ComputeError);
}

}  // namespace
}  // namespace quadrille::galerkin
