#include "galerkin/hybridised.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "../test_meshes.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "plane_functions.hpp"
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

TEST(TraceData, OfTheCurvesThemselvesRunAlongEachEdgeFromItsLowerVertex) {
  const TriMesh mesh = parallelogram_mesh({0, 0}, {2, 0}, {0.5, 1.5}, 2);
  const mesh::TriTopology topology = mesh::tri_topology(mesh);
  std::vector<int> elimination_order(mesh.vertices.size() + topology.edge2vertices.size());
  std::iota(elimination_order.begin(), elimination_order.end(), 0);
  const DofMap map = make_trace_map(mesh, topology, elimination_order, std::vector<int>(mesh.num_elems(), 3));
  const Eigen::MatrixXd values =
      trace_data(mesh, topology, map, [&](int curve, double t) { return curve::point(mesh.face.curves[curve], t); });
  ASSERT_EQ(values.rows(), map.num_dofs - map.num_unknowns);
  for (const BoundaryEdge& boundary : mesh.boundary_edges) {
    const int edge = topology.elem2edges[boundary.elem][boundary.edge];
    const Vec2 low = mesh.vertices[topology.edge2vertices[edge][0]],
               high = mesh.vertices[topology.edge2vertices[edge][1]];
    for (const double r : {-1.0, -0.3, 0.8}) {
      Eigen::VectorXd modes(4);
      trace_values(3, r, modes.data());
      const Eigen::VectorXd x = values.middleRows(map.edge2dof[edge] - map.num_unknowns, 4).transpose() * modes;
      EXPECT_NEAR(distance({x[0], x[1]}, low + (1 + r) / 2 * (high - low)), 0, 1e-13);
    }
  }
}

/// A unit square of 3 x 3 cells: 21 inner edges.
struct HybridisedMethod : testing::Test {
  TriMesh mesh = parallelogram_mesh({0, 0}, {1, 0}, {0, 1}, 3);
  MeshContext context{mesh};

  std::vector<int> uniform(int order) const { return std::vector<int>(mesh.num_elems(), order); }
};

Vec2 rough(Vec2 x) { return {std::exp(3 * x.x), std::sin(5 * x.y)}; }

TEST_F(HybridisedMethod, UnknownsAreTracesOnInnerEdgesOfTheGreaterOrder) {
  const HybridisedGalerkin method(context, on_boundary(mesh, cube));
  EXPECT_EQ(method.num_unknowns(uniform(1)), 21 * 2);
  EXPECT_EQ(method.num_unknowns(uniform(4)), 21 * 5);
  std::vector<int> orders = uniform(4);
  const int inner = 8;  // an element of the cell in the middle
  for (const int other : context.topology.elem2neighbors[inner]) ASSERT_GE(other, 0);
  orders[inner] = 6;
  EXPECT_EQ(method.num_unknowns(orders), 21 * 5 + 3 * 2);
  orders[inner] = 2;
  EXPECT_EQ(method.num_unknowns(orders), 21 * 5);
}

TEST_F(HybridisedMethod, HarmonicPolynomialsAreExactForEveryPenalty) {
  for (const double penalty : {1.5, 3.0, 20.0}) {
    HybridisedGalerkin method(context, on_boundary(mesh, cube), 1, penalty);
    const Solution solution = method.solve(uniform(3));
    EXPECT_LT(greatest_error(context, uniform(3), solution.elem_coefs, cube), 1e-12);
    EXPECT_LT(solution.residual, 1e-12);
    EXPECT_EQ(solution.num_unknowns, 21 * 4);
    EXPECT_EQ(solution.laps.back().phase, "coefficients");
  }
}

TEST_F(HybridisedMethod, AnElementFollowsTheOrdersOfItsNeighbours) {
  std::vector<int> orders = uniform(4);
  HybridisedGalerkin used(context, on_boundary(mesh, rough));
  used.solve(orders);
  orders[8] = 7;  // changes the traces of its neighbours, whose own orders stay
  HybridisedGalerkin fresh(context, on_boundary(mesh, rough), 2);
  const Solution again = used.solve(orders), expected = fresh.solve(orders);
  for (int e = 0; e < mesh.num_elems(); ++e) EXPECT_EQ(again.elem_coefs[e], expected.elem_coefs[e]) << e;
}

TEST_F(HybridisedMethod, TheErrorFallsWithTheOrder) {
  const auto harmonic = [](Vec2 x) {
    return Vec2{std::exp(3 * x.x) * std::cos(3 * x.y), std::exp(3 * x.x) * std::sin(3 * x.y)};
  };
  double last = 20;
  for (const int order : {2, 4, 6}) {
    HybridisedGalerkin method(context, on_boundary(mesh, harmonic));
    const double error = greatest_error(context, uniform(order), method.solve(uniform(order)).elem_coefs, harmonic);
    EXPECT_LT(error, last / 20) << order;
    last = error;
  }
}

TEST_F(HybridisedMethod, APenaltyThatDoesNotHoldTheElementsTogetherIsRefusedWithAnElement) {
  HybridisedGalerkin method(context, on_boundary(mesh, cube), 1, 0.01);
  try {
    method.solve(uniform(4));
    FAIL() << "no exception";
  } catch (const ComputeError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("element ")) << error.what();
  }
}

}  // namespace
}  // namespace quadrille::galerkin
