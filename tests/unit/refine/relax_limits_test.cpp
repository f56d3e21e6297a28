#include "refine/relax_limits.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "refine/validity.hpp"

namespace quadrille::refine {
namespace {

RelaxState state_of(const RelaxProblem& problem, VertexMoves moves) {
  RelaxState state{problem.start, std::move(moves), 0};
  state.mesh.nodes = problem.follow.nodes(state.moves);
  state.energy = problem.total_energy(state.mesh.nodes);
  measure_elements(state.mesh);
  return state;
}

/// Moves of one vertex, by `move`, and of none.
struct OneMove {
  VertexMoves none, one;
  int vertex = -1;

  OneMove(const RelaxProblem& problem, bool on_boundary, Vec2 move)
      : none(problem.num_vertices()), one(problem.num_vertices()) {
    for (int v = 0; v < problem.num_vertices() && vertex < 0; ++v)
      if (!problem.is_fixed[v] && (problem.follow.on_boundary(v) >= 0) == on_boundary) vertex = v;
    one[vertex] = move;
  }
};

TEST(RelaxLimits, MovesThatImproveTheWorstElementStay) {
  // One vertex of a regular mesh was moved away: moving it back breaks no limit.
  const QuadMesh mesh = refined(hand_made::unit_square(), {0.25, 2, 5e-7});
  const RelaxProblem problem(mesh, {});
  const OneMove move(problem, false, {0.03, 0.02});
  const RelaxState state = state_of(problem, move.one);
  RelaxState trial = state_of(problem, move.none);
  EXPECT_FALSE(reset_forbidden_moves(problem, state, 1, trial));
  EXPECT_EQ(trial.moves, move.none);
}

TEST(RelaxLimits, MovesThatMakeAnElementWorseThanTheWorstAreReset) {
  const QuadMesh mesh = refined(hand_made::unit_square(), {0.25, 2, 5e-7});
  const RelaxProblem problem(mesh, {});
  const OneMove move(problem, false, {0.03, 0.02});
  const RelaxState state = state_of(problem, move.none);
  RelaxState trial = state_of(problem, move.one);
  EXPECT_TRUE(reset_forbidden_moves(problem, state, 1, trial));
  EXPECT_EQ(trial.moves, move.none);
}

TEST(RelaxLimits, MeasuresOfMovedElementsAreNewAndOthersAreKept) {
  const QuadMesh mesh = refined(hand_made::unit_square(), {0.25, 2, 5e-7});
  const RelaxProblem problem(mesh, {});
  const OneMove move(problem, false, {0.03, 0.02});
  RelaxState state = state_of(problem, move.none), trial = state_of(problem, move.one);
  const std::vector<double> measured = trial.mesh.elem_scaled_jacobian;
  std::fill(trial.mesh.elem_scaled_jacobian.begin(), trial.mesh.elem_scaled_jacobian.end(), -7);
  reset_forbidden_moves(problem, state, 1, trial);
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    EXPECT_NEAR(trial.mesh.elem_scaled_jacobian[elem], measured[elem], 1e-12) << elem;
}

TEST(RelaxLimits, MovesThatTakeTheBoundaryOutOfItsToleranceAreReset) {
  // On a ring all elements are alike under a turn: only the boundary's tolerance can stand against the move of a ring.
  const QuadMesh mesh = refined(hand_made::cut_annulus(3), {0.3, 2, 1e-2});
  const RelaxProblem problem(mesh, {});
  VertexMoves turned(problem.num_vertices());
  for (int v = 0; v < problem.num_vertices(); ++v) {
    const int b = problem.follow.on_boundary(v);
    if (b >= 0) turned[v] = {problem.boundary.vertices()[b].loop == 0 ? 1e-3 : 0.0, 0};
  }
  const RelaxState state = state_of(problem, VertexMoves(problem.num_vertices()));
  double error = 0;
  for (int e = 0; e < static_cast<int>(problem.boundary.edges().size()); ++e)
    error = std::max(error, problem.boundary.edge_error(e, 0, 0));
  RelaxState tight = state_of(problem, turned);
  EXPECT_TRUE(reset_forbidden_moves(problem, state, error / 2, tight));
  EXPECT_EQ(tight.moves, state.moves);
}

}  // namespace
}  // namespace quadrille::refine
