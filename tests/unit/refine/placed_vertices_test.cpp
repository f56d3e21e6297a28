#include "refine/placed_vertices.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../hand_made.hpp"
#include "../support/refined.hpp"

namespace quadrille::refine {
namespace {

QuadMesh mesh_of(const SeparatrixGraph& graph, double size) {
  return refined(graph, {.size = size, .order = 2, .geometry_tol = 1e-2, .relax = Relax::none});
}

/// Moves that vertices may make.
VertexMoves sample(const RelaxProblem& problem) {
  VertexMoves sample(problem.num_vertices());
  for (int v = 0; v < problem.num_vertices(); ++v) {
    if (problem.is_fixed[v]) continue;
    sample[v] = {0.02 * std::sin(v + 1.0), 0.02 * std::cos(v + 1.0)};
    if (problem.follow.on_boundary(v) >= 0) sample[v].y = 0;
  }
  problem.join_twins(sample);
  return sample;
}

double greatest_difference(const VertexMoves& a, const VertexMoves& b) {
  double greatest = 0;
  for (std::size_t v = 0; v < a.size(); ++v) greatest = std::max(greatest, norm(a[v] - b[v]));
  return greatest;
}

TEST(PlacedVertices, OfTheSameMeshHaveTheSameMoves) {
  for (const SeparatrixGraph& graph : {hand_made::unit_square(), hand_made::cut_annulus(3), hand_made::l_shape()}) {
    const RelaxProblem problem(mesh_of(graph, 0.2), {});
    const VertexMoves moves = sample(problem);
    EXPECT_LT(greatest_difference(PlacedVertices(problem, moves).moves(problem), moves), 1e-12);
  }
}

/// What a shear of the square moves, which keeps its sides, it moves with all counts.
TEST(PlacedVertices, OfOtherCountsAreLinearBetweenVertices) {
  const auto sheared = [](const RelaxProblem& problem) {
    VertexMoves moves(problem.num_vertices());
    for (int elem = 0; elem < problem.start.num_elems(); ++elem)
      for (int c = 0; c < 4; ++c) {
        const int v = problem.follow.elem_vertices()[elem][c];
        const Vec2 x = problem.start.nodes[side_start(problem.start, elem, c)];
        if (problem.is_fixed[v]) continue;
        const int b = problem.follow.on_boundary(v);
        if (b < 0)
          moves[v] = {0.1 * x.x * (1 - x.x), 0};
        else if (std::abs(problem.boundary.at(b, 0).tangent.y) < 0.5)
          moves[v] = {0.1 * x.x * (1 - x.x) * problem.boundary.at(b, 0).tangent.x, 0};
      }
    return moves;
  };
  const RelaxProblem coarse(mesh_of(hand_made::unit_square(), 0.05), {});
  const RelaxProblem fine(mesh_of(hand_made::unit_square(), 0.04), {});
  const VertexMoves moves = PlacedVertices(coarse, sheared(coarse)).moves(fine);
  EXPECT_LT(greatest_difference(moves, sheared(fine)), 0.1 * 0.05 * 0.05);  // of a parabola between vertices
  EXPECT_GT(greatest_difference(moves, VertexMoves(moves.size())), 0.02);
}

TEST(PlacedVertices, ThatAreFixedStay) {
  const RelaxProblem problem(mesh_of(hand_made::unit_square(), 0.25), {});
  const VertexMoves moved = PlacedVertices(problem, sample(problem)).moves(problem);
  for (int v = 0; v < problem.num_vertices(); ++v) {
    if (!problem.is_fixed[v]) continue;
    EXPECT_EQ(moved[v], Vec2{});
  }
}

}  // namespace
}  // namespace quadrille::refine
