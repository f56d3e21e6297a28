#include "refine/relax_problem.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "../hand_made.hpp"
#include "block/extract_blocks.hpp"
#include "refine/refine.hpp"

namespace quadrille::refine {
namespace {

/// The unit square in 4 x 4 elements: 25 vertices, 9 of them inside.
QuadMesh square_mesh_of(int order) {
  Report report;
  return refine(block::extract_blocks(hand_made::unit_square(), report), {0.25, order, 5e-7}, report);
}

Vec2 place(const RelaxProblem& problem, int vertex) {
  for (int elem = 0; elem < problem.start.num_elems(); ++elem)
    for (int k = 0; k < 4; ++k)
      if (problem.follow.elem_vertices()[elem][k] == vertex) {
        const int n = problem.start.order, width = n + 1;
        const std::array<int, 4> local{0, n, width * width - 1, n * width};
        return problem.start.nodes[problem.start.elem_nodes[elem * width * width + local[k]]];
      }
  return {};
}

TEST(RelaxProblem, OnlyCornersOfTheFaceAreFixed) {
  const RelaxProblem problem(square_mesh_of(3), {});
  ASSERT_EQ(problem.num_vertices(), 25);
  for (int v = 0; v < 25; ++v) {
    const Vec2 x = place(problem, v);
    const bool is_corner = (x.x == 0 || x.x == 1) && (x.y == 0 || x.y == 1);
    EXPECT_EQ(problem.is_fixed[v], is_corner) << x.x << ", " << x.y;
  }
}

TEST(RelaxProblem, FrozenElementsFixTheirVertices) {
  const QuadMesh mesh = square_mesh_of(2);
  std::vector<bool> frozen(16, false);
  frozen[5] = true;
  const RelaxProblem problem(mesh, frozen);
  EXPECT_EQ(std::count(problem.is_fixed.begin(), problem.is_fixed.end(), true), 4 + 4);
  for (const int v : problem.follow.elem_vertices()[5]) EXPECT_TRUE(problem.is_fixed[v]);
}

TEST(RelaxProblem, AMeshAsItIsHasTheEnergyOnePerElement) {
  // mu = 1 where the derivatives are normal to each other and as long as in the mesh itself.
  const RelaxProblem problem(square_mesh_of(3), {});
  EXPECT_NEAR(problem.total_energy(problem.start.nodes), 16, 1e-10);
}

TEST(RelaxProblem, AShearRaisesTheEnergyByAKnownFactor) {
  // x + s y: |a| = 1, |b|^2 = 1 + s^2, a x b = 1: mu = 1 + s^2 / 2, the same at every node of every element.
  const RelaxProblem problem(square_mesh_of(3), {});
  const auto sheared = [&](double s) {
    std::vector<Vec2> nodes = problem.start.nodes;
    for (Vec2& x : nodes) x.x += s * x.y;
    return problem.total_energy(nodes) / 16;
  };
  // mu^p for one p.
  const double p = std::log(sheared(1)) / std::log(1.5);
  EXPECT_GE(p, 1);
  EXPECT_NEAR(sheared(0.4), std::pow(1.08, p), 1e-9);
}

TEST(RelaxProblem, AFoldedMeshHasInfiniteEnergy) {
  const RelaxProblem problem(square_mesh_of(2), {});
  std::vector<Vec2> nodes = problem.start.nodes;
  for (Vec2& x : nodes)
    if (distance(x, {0.5, 0.5}) < 1e-9) x = {0.9, 0.5};
  EXPECT_EQ(problem.total_energy(nodes), std::numeric_limits<double>::infinity());
}

TEST(RelaxProblem, KeepsACopyOfTheMesh) {
  QuadMesh mesh = square_mesh_of(2);
  const RelaxProblem problem(mesh, {});
  const std::vector<Vec2> before = mesh.nodes;
  for (Vec2& x : mesh.nodes) x = {7, 7};
  EXPECT_EQ(problem.start.nodes, before);
  EXPECT_NEAR(problem.total_energy(before), 16, 1e-10);
}

}  // namespace
}  // namespace quadrille::refine
