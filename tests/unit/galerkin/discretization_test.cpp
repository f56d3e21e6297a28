#include "galerkin/discretization.hpp"

#include <gtest/gtest.h>

#include "../test_meshes.hpp"
#include "base/error.hpp"
#include "plane_functions.hpp"

namespace quadrille::galerkin {
namespace {

/// A unit square of 3 x 3 cells: 4 inner vertices and 21 inner edges.
struct Continuous : testing::Test {
  TriMesh mesh = parallelogram_mesh({0, 0}, {1, 0}, {0, 1}, 3);
  MeshContext context{mesh};
  ContinuousSystem system{context};
  Stopwatch watch;

  std::vector<int> uniform(int order) const { return std::vector<int>(mesh.num_elems(), order); }
  std::vector<int> mixed() const {
    std::vector<int> orders;
    for (int e = 0; e < mesh.num_elems(); ++e) orders.push_back(3 + (5 * e) % 12);
    return orders;
  }
  Eigen::MatrixXd given(const PlaneFunction& f) const {
    return DirichletData(mesh, on_boundary(mesh, f)).values(context.topology, system.map());
  }
};

TEST_F(Continuous, UnknownsAreInnerVerticesAndModesOfInnerEdges) {
  EXPECT_EQ(system.num_unknowns(uniform(1)), 4);
  EXPECT_EQ(system.num_unknowns(uniform(4)), 4 + 21 * 3);
  system.set_orders(uniform(4), watch);
  EXPECT_EQ(system.map().num_unknowns, 4 + 21 * 3);
  EXPECT_EQ(system.num_unknowns(uniform(2)), 4 + 21);  // asked for another order map
}

TEST_F(Continuous, HarmonicPolynomialsAreExactWhateverTheOrders) {
  for (const std::vector<int>& orders : {uniform(3), mixed()}) {
    system.set_orders(orders, watch);
    const Eigen::MatrixXd dofs = system.solve(given(cube), watch);
    EXPECT_LT(system.residual(dofs), 1e-13);
    EXPECT_LT(greatest_error(context, orders, system.all_coefs(dofs), cube), 1e-13);
  }
}

TEST_F(Continuous, TheProductOfDataAndReactionsIsTheEnergy) {
  // int |grad (x^2 - y^2)|^2 = int 4 x^2 + 4 y^2 = 8 / 3 on the unit square, and as much for 2 x y; their product is 0.
  system.set_orders(uniform(5), watch);
  const Eigen::MatrixXd data = given([](Vec2 x) { return Vec2{x.x * x.x - x.y * x.y, 2 * x.x * x.y}; });
  const Eigen::MatrixXd energy = data.transpose() * system.reactions(system.solve(data, watch));
  EXPECT_LT((energy - 8.0 / 3 * Eigen::Matrix2d::Identity()).norm(), 1e-12);
}

TEST_F(Continuous, ElementsHaveTheValuesAtTheirVertices) {
  system.set_orders(uniform(4), watch);
  const Eigen::MatrixXd dofs = system.solve(given(cube), watch);
  const std::vector<Eigen::MatrixXd> all = system.all_coefs(dofs);
  for (int e = 0; e < mesh.num_elems(); ++e) {
    EXPECT_EQ(all[e], system.coefs(e, dofs));
    for (int k = 0; k < 3; ++k) {
      const Vec2 value =
          spectral::orthogonal_sum(4, all[e].col(0).data(), all[e].col(1).data(), spectral::tri_edge_point(k, 0));
      EXPECT_NEAR(distance(value, cube(mesh.vertices[mesh.elem2vertices[e][k]])), 0, 1e-13);
    }
  }
}

TEST_F(Continuous, ResultsDoNotDependOnWhatIsKept) {
  const PlaneFunction rough = [](Vec2 x) { return Vec2{std::exp(3 * x.x), std::sin(5 * x.y)}; };
  system.set_orders(mixed(), watch);
  const Eigen::MatrixXd dofs = system.solve(given(rough), watch);
  const std::vector<Eigen::MatrixXd> all = system.all_coefs(dofs);
  for (const std::size_t kept : {std::size_t{0}, std::size_t{3000}}) {
    ContinuousSystem other(context, 2, kept);
    other.set_orders(uniform(5), watch);
    other.set_orders(mixed(), watch);
    EXPECT_EQ(dofs, other.solve(given(rough), watch));
    EXPECT_EQ(all, other.all_coefs(dofs));
    EXPECT_EQ(all.back(), other.coefs(mesh.num_elems() - 1, dofs));
  }
}

TEST_F(Continuous, ChangedOrdersLeaveNoTrace) {
  const PlaneFunction rough = [](Vec2 x) { return Vec2{std::exp(3 * x.x), std::sin(5 * x.y)}; };
  system.set_orders(uniform(6), watch);
  system.solve(given(rough), watch);
  system.set_orders(mixed(), watch);
  const Eigen::MatrixXd again = system.solve(given(rough), watch);
  ContinuousSystem fresh(context, 2);
  fresh.set_orders(mixed(), watch);
  EXPECT_EQ(again, fresh.solve(given(rough), watch));
}

TEST_F(Continuous, TheDiscretisationSolvesBothProblemsAndTimesItsPhases) {
  ContinuousGalerkin method(context, on_boundary(mesh, cube));
  const Solution solution = method.solve(mixed());
  EXPECT_LT(greatest_error(context, mixed(), solution.elem_coefs, cube), 1e-13);
  EXPECT_EQ(solution.num_unknowns, method.num_unknowns(mixed()));
  EXPECT_LT(solution.residual, 1e-13);
  ASSERT_FALSE(solution.laps.empty());
  EXPECT_EQ(solution.laps.front().phase, "elements");
  EXPECT_EQ(solution.laps.back().phase, "coefficients");
}

TEST_F(Continuous, AFoldedElementIsNamed) {
  TriMesh folded = parallelogram_mesh({0, 0}, {1, 0}, {0.4, 1}, 3);
  folded.vertices[5] = {0.9, 0.1};  // pushed across its neighbours
  const MeshContext folded_context(folded);
  ContinuousSystem refused(folded_context);
  EXPECT_THROW(refused.set_orders(std::vector<int>(folded.num_elems(), 4), watch), ComputeError);
}

}  // namespace
}  // namespace quadrille::galerkin
