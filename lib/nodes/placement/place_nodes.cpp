#include "placement/place_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/warning_codes.hpp"
#include "curve/symmetry_lines.hpp"
#include "placement/axis_pairs.hpp"
#include "placement/minimise.hpp"
#include "placement/node_ledger.hpp"
#include "placement/node_symmetry.hpp"
#include "surface/positions.hpp"

namespace quadrille::placement {

namespace {

using Eigen::VectorXd;

constexpr double visible_step = 1e-8;          // diameters: no warning if the last step was shorter
constexpr int iterations_between_scales = 30;  // then the length scales of the nodes are recomputed

constexpr double least_gain = 1e-6;  // of the energy, for another place of a pair

struct Problem {
  const CadFace& face;
  PlacementObjective objective;
  std::vector<NodeSymmetry> group;
  ReducedCoordinates coordinates;
  CriticalPoints points;  ///< with the current positions of the nodes
};

std::vector<int> indices_of(const std::vector<bool>& is_free) {
  std::vector<int> free;
  for (std::size_t k = 0; k < is_free.size(); ++k)
    if (is_free[k]) free.push_back(static_cast<int>(k));
  return free;
}

Problem problem_of(const CadFace& face, const EnergyFunction& energy, const SmoothBoundaryDistance& boundary,
                   const std::vector<bool>& is_free, const PlacementOptions& options, const CriticalPoints& points) {
  const std::vector<int> free = indices_of(is_free);
  Problem problem{face,
                  {energy, boundary, options.weight, free, {}, options.log_scale},
                  node_symmetries(face, points, is_free),
                  {free, {}, {}},
                  points};
  symmetrise(problem.group, is_free, problem.points);
  problem.coordinates.movements = invariant_movements(problem.group, is_free);
  problem.objective.repulsion = repulsion_terms(face, problem.points, is_free, options.pair_reach * face.diameter);
  return problem;
}

/// Value and gradient with respect to y; std::nullopt if a node is not inside the domain. At y = 0 errors of the energy
/// are rethrown.
std::optional<Minimand::Sample> sample(const Problem& problem, const VectorXd& y) {
  NodeEnergy sum;
  try {
    sum = problem.objective.at(problem.coordinates.moved(problem.points, y));
  } catch (const ComputeError&) {
    if (y.isZero(0)) throw;
    return std::nullopt;
  }
  const VectorXd gradient = problem.coordinates.gradient(sum.gradient);
  if (!std::isfinite(sum.value) || !gradient.allFinite()) return std::nullopt;
  return Minimand::Sample{sum.value, gradient};
}

Minimand minimand_of(const Problem& problem, const Progress::Part& evaluations) {
  const ReducedCoordinates& coordinates = problem.coordinates;
  return {[&problem, &evaluations](const VectorXd& y) {
            evaluations.advance();
            return sample(problem, y);
          },
          [&problem, &coordinates](const VectorXd& y, const VectorXd& step) {
            return problem.objective.allowed_part(coordinates.moved(problem.points, y), coordinates.movement(step));
          },
          [&problem, &coordinates](const VectorXd& step) {
            double longest = 0;
            for (const Vec2 move : coordinates.movement(step)) longest = std::max(longest, norm(move));
            return longest / problem.face.diameter;
          }};
}

/// Moves problem.points to a minimum, in rounds between which the scales are recomputed.
Minimum find_minimum(Problem& problem, const PlacementOptions& options, Progress* progress) {
  const Progress::Part part(progress, "evaluations of the energy");
  Minimum result;
  int iterations = 0, evaluations = 0;
  do {
    problem.coordinates.scales =
        length_scales(problem.objective.boundary, problem.points, problem.coordinates.free, problem.group);
    MinimiseOptions round;
    round.tolerance = options.tolerance;
    round.max_iterations = std::min(iterations_between_scales, options.max_iterations - iterations);
    round.begins_with_hessian = iterations > 0;
    result = minimise(minimand_of(problem, part), VectorXd::Zero(problem.coordinates.movements.cols()), round);
    problem.points = problem.coordinates.moved(problem.points, result.x);
    iterations += result.iterations;
    evaluations += result.evaluations;
    if (result.iterations < round.max_iterations) break;
  } while (!result.is_converged && iterations < options.max_iterations);
  result.iterations = iterations;
  result.evaluations = evaluations;
  return result;
}

/// A problem with the minimum in which it ends.
struct Solved {
  Problem problem;
  Minimum minimum;
};

Solved solved(Problem problem, const PlacementOptions& options, Progress* progress) {
  const Minimum minimum = find_minimum(problem, options, progress);
  return {std::move(problem), minimum};
}

/// From the minimum with some pairs on mirror axes to the least energy with one of them beside its axis, while that is
/// lower.
Solved with_pairs_beside_axes(Solved best, const std::vector<bool>& is_free, const PlacementOptions& options,
                              Progress* progress) {
  const PlacementObjective& objective = best.problem.objective;
  for (const CriticalPoints& turned :
       with_turned_pairs(objective.boundary, best.problem.group, is_free, is_free, best.problem.points)) {
    try {
      Solved next =
          solved(problem_of(best.problem.face, objective.energy, objective.boundary, is_free, options, turned), options,
                 progress);
      if (next.minimum.value < best.minimum.value - least_gain * (1 + std::abs(best.minimum.value)))
        return with_pairs_beside_axes(std::move(next), is_free, options, progress);
    } catch (const ComputeError&) {
      continue;  // the energy does not exist at the start
    }
  }
  return best;
}

using surface::position_text;

void report_minimum(const Minimum& minimum, Report& report) {
  report.set("placement.energy_after", minimum.value);
  report.set("placement.iterations", minimum.iterations);
  report.set("placement.evaluations", minimum.evaluations);
  report.set("placement.last_step", minimum.last_step);
  report.set("placement.least_curvature", minimum.least_curvature);
}

void warn_if_not_converged(const Minimum& minimum, Report& report) {
  // Noise of the gradient causes no warning as long as it has no visible effect on the nodes.
  if (minimum.is_converged || (minimum.last_step > 0 && minimum.last_step <= visible_step)) return;
  report.warn(warning::least_energy_not_found,
              fmt::format("the placement of the nodes did not converge in {} iterations: the nodes are "
                          "not at the least energy",
                          minimum.iterations));
}

void warn_of_close_pairs(const Problem& problem, Report& report) {
  const auto& nodes = problem.points.critical_points;
  for (const RepulsionTerm& term : problem.objective.repulsion) {
    const double r = pair_distance(term, problem.points);
    if (r >= term.reach) continue;
    const Vec2 x = nodes[term.node].position, other = term.other ? nodes[*term.other].position : term.position;
    const double scale = mean_scale(problem.objective.log_scale, problem.objective.boundary, x, other);
    report.warn(warning::nodes_kept_apart,
                fmt::format("the node of valence {} at {} and the {} at {} attract each other and would meet: "
                            "they are kept {:.3g} apart",
                            nodes[term.node].valence, position_text(problem.face, x), term.other ? "node" : "corner",
                            position_text(problem.face, other), r * scale));
  }
}

}  // namespace

void place_nodes(const CadFace& face, const EnergyFunction& energy, const std::vector<bool>& is_free,
                 const PlacementOptions& options, CriticalPoints& points, Report& report) {
  if (std::none_of(is_free.begin(), is_free.end(), [](bool free) { return free; })) return;
  const CadFace whole = curve::whole_of(face, options.symmetry);
  const SmoothBoundaryDistance boundary(whole);
  Problem start = problem_of(face, energy, boundary, is_free, options, points);
  report.set("placement.energy_before", start.objective.at(start.points).value);
  const auto [problem, minimum] =
      with_pairs_beside_axes(solved(std::move(start), options, report.progress()), is_free, options, report.progress());
  report_minimum(minimum, report);
  report.set("placement.symmetries", problem.group.size());
  warn_if_not_converged(minimum, report);
  warn_of_close_pairs(problem, report);
  record_moves(
      face, problem.points,
      [&](double way) {
        return fmt::format("moved by {:.3g} to the least energy (weight of the boundary term {:g})", way,
                           options.weight);
      },
      points);
}

}  // namespace quadrille::placement
