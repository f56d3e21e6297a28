#include "galerkin/condensed_system.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "../test_meshes.hpp"
#include "mesh/tri_maps.hpp"
#include "stiffness/element_matrices.hpp"

namespace quadrille::galerkin {
namespace {

// The condensed Laplacian on a parallelogram of area 3, with the linear functions x and y as columns of `dofs`.
struct System {
  TriMesh mesh = parallelogram_mesh({0, 0}, {2, 0}, {0.5, 1.5}, 3);
  DofMap map;
  CondensedElements elements;
  Eigen::MatrixXd dofs;

  System() {
    const mesh::TriTopology topology = mesh::tri_topology(mesh);
    std::vector<int> elimination_order(mesh.vertices.size() + topology.edge2vertices.size());
    std::iota(elimination_order.begin(), elimination_order.end(), 0);
    map = make_dof_map(mesh, topology, elimination_order, std::vector<int>(mesh.num_elems(), 4));
    for (const spectral::TriMap& tri : mesh::tri_maps(mesh))
      elements.push_back(
          std::make_shared<CondensedElement>(stiffness::condense(4, stiffness::stiffness_matrix(tri, 4))));
    dofs = Eigen::MatrixXd::Zero(map.num_dofs, 2);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
      dofs.row(map.vertex2dof[v]) << mesh.vertices[v].x, mesh.vertices[v].y;
  }
  Eigen::MatrixXd given() const { return dofs.bottomRows(map.num_dofs - map.num_unknowns); }
};

TEST(CondensedSystem, LinearFunctionsSolveIt) {
  const System system;
  const Eigen::MatrixXd rhs = right_hand_side(system.map, system.elements, system.given());
  EXPECT_GT(rhs.norm(), 0.1);
  EXPECT_LT(relative_residual(system.map, system.elements, rhs, system.dofs), 1e-13);
  Eigen::MatrixXd other = system.dofs;
  other(0, 0) += 1;
  EXPECT_GT(relative_residual(system.map, system.elements, rhs, other), 1e-2);
}

TEST(CondensedSystem, ReactionsGiveTheEnergyProduct) {
  const System system;
  const Eigen::MatrixXd products = system.given().transpose() * reactions(system.map, system.elements, system.dofs);
  EXPECT_LT((products - 3 * Eigen::MatrixXd::Identity(2, 2)).norm(), 1e-12);
}

TEST(CondensedSystem, SparseDataAreThoseOfDenseColumns) {
  const System system;
  const Eigen::MatrixXd given = system.given();
  const SparseData data = sparse_data(system.map, system.elements, given.sparseView());
  EXPECT_LT((data.rhs - right_hand_side(system.map, system.elements, given)).norm(), 1e-13);
  Eigen::MatrixXd zero_inside = system.dofs;
  zero_inside.topRows(system.map.num_unknowns).setZero();
  const Eigen::MatrixXd products = given.transpose() * reactions(system.map, system.elements, zero_inside);
  EXPECT_LT((data.product - products).norm(), 1e-13 * products.norm());
}

TEST(CondensedSystem, ConstantsHaveNoReaction) {
  const System system;
  Eigen::MatrixXd one = Eigen::MatrixXd::Zero(system.map.num_dofs, 1);
  for (const int dof : system.map.vertex2dof) one(dof, 0) = 1;
  EXPECT_LT(reactions(system.map, system.elements, one).norm(), 1e-12);
}

TEST(CondensedSystem, ElementsHaveTheDofsOfTheirVerticesFirst) {
  const System system;
  for (int e = 0; e < system.mesh.num_elems(); ++e) {
    const Eigen::MatrixXd local = element_dofs(system.map, e, system.dofs);
    for (int k = 0; k < 3; ++k) {
      const Vec2 x = system.mesh.vertices[system.mesh.elem2vertices[e][k]];
      EXPECT_EQ(local(k, 0), x.x);
      EXPECT_EQ(local(k, 1), x.y);
    }
  }
}

}  // namespace
}  // namespace quadrille::galerkin
