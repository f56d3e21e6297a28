#include "refine/conjugate_descent.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../hand_made.hpp"
#include "../support/refined.hpp"

namespace quadrille::refine {
namespace {

/// The unit square with skewed elements inside.
QuadMesh skew_square() {
  QuadMesh mesh = refined(hand_made::unit_square(), {0.25, 2, 5e-7});
  for (Vec2& x : mesh.nodes) x += 0.2 * x.x * (1 - x.x) * x.y * (1 - x.y) * Vec2{4 * x.y, 3 + x.x};
  return mesh;
}

TEST(ConjugateDescent, ASmallStepLowersTheEnergy) {
  const QuadMesh mesh = skew_square();
  const RelaxProblem problem(mesh, {});
  VertexMoves moves(problem.num_vertices());
  ConjugateDescent descent(problem);
  double before = problem.total_energy(mesh.nodes);
  for (int step = 0; step < 3; ++step) {
    const VertexMoves direction = descent.next(problem.follow.nodes(moves), moves);
    for (std::size_t v = 0; v < moves.size(); ++v) moves[v] += 0.1 * direction[v];
    const double after = problem.total_energy(problem.follow.nodes(moves));
    EXPECT_LT(after, before) << step;
    before = after;
  }
}

TEST(ConjugateDescent, FixedVerticesAndFrozenElementsStay) {
  const QuadMesh mesh = skew_square();
  std::vector<bool> frozen(mesh.num_elems(), false);
  frozen[5] = true;
  const RelaxProblem problem(mesh, frozen);
  const VertexMoves direction = ConjugateDescent(problem).next(mesh.nodes, VertexMoves(problem.num_vertices()));
  int num_fixed = 0;
  for (int v = 0; v < problem.num_vertices(); ++v)
    if (problem.is_fixed[v]) {
      EXPECT_EQ(direction[v], Vec2{});
      ++num_fixed;
    }
  EXPECT_EQ(num_fixed, 8) << "the corners of the square and of the frozen element";
}

TEST(ConjugateDescent, NoVertexMovesByMoreThanAQuarterOfTheShortestEdge) {
  QuadMesh mesh = skew_square();
  const RelaxProblem problem(mesh, {});
  double shortest = 1e300;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const int* n = &mesh.elem_nodes[elem * 9];
    for (const auto& [a, b] : {std::pair{0, 2}, {2, 8}, {8, 6}, {6, 0}})
      shortest = std::min(shortest, distance(mesh.nodes[n[a]], mesh.nodes[n[b]]));
  }
  ASSERT_LT(shortest, 0.25);
  for (const Vec2 move : ConjugateDescent(problem).next(mesh.nodes, VertexMoves(problem.num_vertices())))
    EXPECT_LE(norm(move), 0.25 * 0.4);
}

TEST(ConjugateDescent, VerticesOnTheBoundaryMoveAlongIt) {
  const QuadMesh mesh = refined(hand_made::quarter_annulus(), {0.4, 2, 1e-2});
  const RelaxProblem problem(mesh, {});
  const VertexMoves direction = ConjugateDescent(problem).next(mesh.nodes, VertexMoves(problem.num_vertices()));
  for (int v = 0; v < problem.num_vertices(); ++v)
    if (problem.follow.on_boundary(v) >= 0) {
      EXPECT_EQ(direction[v].y, 0);
    }
}

}  // namespace
}  // namespace quadrille::refine
