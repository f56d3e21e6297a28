#include "galerkin/condensed_system.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "../test_meshes.hpp"
#include "mesh/elimination_tree.hpp"
#include "mesh/tri_topology.hpp"
#include "stiffness/element_matrices.hpp"

namespace quadrille::galerkin {
namespace {

const TriMesh mesh = parallelogram_mesh({0, 0}, {1, 0}, {0, 1}, 4);

TEST(DofMap, CountsVerticesAndEdges) {
  const mesh::TriTopology topology = mesh::tri_topology(mesh);
  const int order = 5, num_edges = static_cast<int>(topology.edge2vertices.size());
  const DofMap map = make_dof_map(mesh, topology, mesh::nested_dissection(mesh, topology).elimination_order,
                                  std::vector<int>(mesh.num_elems(), order));
  EXPECT_EQ(map.num_dofs, static_cast<int>(mesh.vertices.size()) + num_edges * (order - 1));
  const int inner_vertices = 3 * 3, inner_edges = num_edges - 16;
  EXPECT_EQ(map.num_unknowns, inner_vertices + inner_edges * (order - 1));
}

TEST(DofMap, AnyDofsCanBeGiven) {
  const mesh::TriTopology topology = mesh::tri_topology(mesh);
  std::vector<bool> is_given(mesh.vertices.size() + topology.edge2vertices.size(), false);
  is_given[3] = true;
  const DofMap map = make_dof_map(mesh, topology, mesh::nested_dissection(mesh, topology).elimination_order,
                                  std::vector<int>(mesh.num_elems(), 4), is_given);
  EXPECT_EQ(map.num_unknowns, map.num_dofs - 1);
  EXPECT_EQ(map.vertex2dof[3], map.num_unknowns);
}

TEST(DofMap, EdgesTakeTheLowerOrder) {
  const mesh::TriTopology topology = mesh::tri_topology(mesh);
  std::vector<int> orders(mesh.num_elems());
  for (int e = 0; e < mesh.num_elems(); ++e) orders[e] = 2 + e % 4;
  const DofMap map = make_dof_map(mesh, topology, mesh::nested_dissection(mesh, topology).elimination_order, orders);
  for (std::size_t edge = 0; edge < topology.edge2elems.size(); ++edge) {
    const auto& [a, b] = topology.edge2elems[edge];
    EXPECT_EQ(map.edge2order[edge], b < 0 ? orders[a] : std::min(orders[a], orders[b]));
  }
  for (int e = 0; e < mesh.num_elems(); ++e) {
    const int offset = map.elem2offset[e];
    EXPECT_EQ(map.elem2offset[e + 1] - offset, 3 * orders[e]);
    for (int k = 0; k < 3; ++k) {
      const int edge = topology.elem2edges[e][k];
      for (int d = 2; d <= orders[e]; ++d) {
        const int dof = map.elem2dofs[offset + 3 + k * (orders[e] - 1) + d - 2];
        EXPECT_EQ(dof, d <= map.edge2order[edge] ? map.edge2dof[edge] + d - 2 : -1);
      }
    }
  }
}

TEST(DofMap, NeighboursDisagreeInSignExactlyForOddDegrees) {
  const mesh::TriTopology topology = mesh::tri_topology(mesh);
  const int order = 6;
  const DofMap map = make_dof_map(mesh, topology, mesh::nested_dissection(mesh, topology).elimination_order,
                                  std::vector<int>(mesh.num_elems(), order));
  for (int e = 0; e < mesh.num_elems(); ++e) {
    for (int k = 0; k < 3; ++k) {
      const int other = topology.elem2neighbors[e][k];
      if (other < 0) continue;
      const int there = topology.elem2neighbor_edges[e][k];
      for (int d = 2; d <= order; ++d) {
        const double mine = map.elem2signs[map.elem2offset[e] + 3 + k * (order - 1) + d - 2];
        const double others = map.elem2signs[map.elem2offset[other] + 3 + there * (order - 1) + d - 2];
        EXPECT_EQ(mine * others, d % 2 == 0 ? 1 : -1);
      }
    }
  }
}

TEST(DofMap, NumbersEachDofOnceAndBoundaryDofsLast) {
  const mesh::TriTopology topology = mesh::tri_topology(mesh);
  const DofMap map = make_dof_map(mesh, topology, mesh::nested_dissection(mesh, topology).elimination_order,
                                  std::vector<int>(mesh.num_elems(), 3));
  std::set<int> seen;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    EXPECT_TRUE(seen.insert(map.vertex2dof[v]).second);
    const Vec2 x = mesh.vertices[v];
    const bool on_boundary = std::min({x.x, x.y, 1 - x.x, 1 - x.y}) < 1e-12;
    EXPECT_EQ(map.vertex2dof[v] >= map.num_unknowns, on_boundary);
  }
  for (const int first : map.edge2dof) {
    EXPECT_TRUE(seen.insert(first).second);
    EXPECT_TRUE(seen.insert(first + 1).second);
  }
  EXPECT_EQ(*seen.begin(), 0);
  EXPECT_EQ(*seen.rbegin(), map.num_dofs - 1);
  EXPECT_EQ(static_cast<int>(seen.size()), map.num_dofs);
}

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
