#include "refine/relax.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "refine/conjugate_descent.hpp"
#include "refine/relax_limits.hpp"
#include "refine/relax_problem.hpp"
#include "refine/validity.hpp"

namespace quadrille::refine {
namespace {

/// Relaxation ends after a sweep that lowers the energy by less than this fraction of its excess over its least value,
/// 1 for each element.
constexpr double least_progress = 1e-7;
constexpr int max_halvings = 6;
/// Greatest number of resets of moves in one trial.
constexpr int max_resets = 12;
constexpr double greatest_first_length = 8;

/// Resets the moves that break a limit, and accepts the others as the new state if the energy decreases.
bool accept(const RelaxProblem& problem, double tolerance, VertexMoves moves, RelaxState& state) {
  RelaxState trial{state.mesh, std::move(moves), 0};
  for (int round = 0; round < max_resets; ++round) {
    trial.mesh.nodes = problem.follow.nodes(trial.moves);
    trial.energy = problem.total_energy(trial.mesh.nodes);
    if (!(trial.energy < state.energy)) return false;
    if (reset_forbidden_moves(problem, state, tolerance, trial)) continue;
    state = std::move(trial);
    return true;
  }
  return false;
}

/// One sweep: a step along `direction`, halved until it is accepted; false if no vertex could be moved. `first_length`
/// is the first step length of the line search, and is adapted for the next sweep.
bool step(const RelaxProblem& problem, double tolerance, const VertexMoves& direction, double& first_length,
          RelaxState& state) {
  double length = first_length;
  for (int halving = 0; halving < max_halvings; ++halving, length /= 2) {
    VertexMoves moves = state.moves;
    for (std::size_t v = 0; v < moves.size(); ++v) moves[v] += length * direction[v];
    if (!accept(problem, tolerance, std::move(moves), state)) continue;
    first_length = std::min(halving == 0 ? 2 * length : length, greatest_first_length);
    return true;
  }
  return false;
}

double least_scaled_jacobian(const QuadMesh& mesh) {
  return *std::min_element(mesh.elem_scaled_jacobian.begin(), mesh.elem_scaled_jacobian.end());
}

double mean_scaled_jacobian(const QuadMesh& mesh) {
  return std::accumulate(mesh.elem_scaled_jacobian.begin(), mesh.elem_scaled_jacobian.end(), 0.0) / mesh.num_elems();
}

}  // namespace

RelaxOutcome relax(QuadMesh& mesh, const RelaxOptions& options) {
  if (options.sweeps == 0 || !mesh.is_valid) return {};
  const RelaxProblem problem(mesh, options.frozen_elems);
  ConjugateDescent descent(problem);
  RelaxState state{mesh, VertexMoves(problem.num_vertices()), problem.total_energy(mesh.nodes)};
  RelaxOutcome outcome;
  const double num_elems = mesh.num_elems(), energy_before = state.energy;
  double first_length = 1;
  const Progress::Part part(options.progress, "sweeps", options.sweeps, Progress::Total::bound);
  for (int sweep = 0; sweep < options.sweeps; ++sweep, part.advance()) {
    const double before = state.energy;
    if (!step(problem, options.tolerance, descent.next(state.mesh.nodes, state.moves), first_length, state)) break;
    ++outcome.sweeps;
    if (before - state.energy < least_progress * (before - num_elems)) break;
  }
  const double per_elem = 1.0 / num_elems;
  outcome.energy_before = energy_before * per_elem;
  outcome.energy_after = state.energy * per_elem;
  for (const Vec2 move : state.moves) outcome.largest_move = std::max(outcome.largest_move, norm(move));
  mesh = std::move(state.mesh);
  measure_elements(mesh);
  return outcome;
}

void relax_and_report(QuadMesh& mesh, const RelaxOptions& options, Report& report) {
  report.set("relax.least_scaled_jacobian_before", least_scaled_jacobian(mesh));
  report.set("relax.mean_scaled_jacobian_before", mean_scaled_jacobian(mesh));
  const RelaxOutcome outcome = relax(mesh, options);
  report.set("relax.sweeps", outcome.sweeps);
  report.set("relax.energy_before", outcome.energy_before);
  report.set("relax.energy_after", outcome.energy_after);
  report.set("relax.largest_move", outcome.largest_move);
}

}  // namespace quadrille::refine
