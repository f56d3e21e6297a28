#include "galerkin/hybridised.hpp"

#include <gtest/gtest.h>

#include "../test_meshes.hpp"
#include "base/error.hpp"
#include "plane_functions.hpp"

namespace quadrille::galerkin {
namespace {

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
