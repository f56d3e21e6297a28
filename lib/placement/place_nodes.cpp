#include "placement/place_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/position_text.hpp"
#include "base/warning_codes.hpp"
#include "placement/minimise.hpp"
#include "placement/node_symmetry.hpp"
#include "placement/reduced_coordinates.hpp"

namespace quadrille::placement {

namespace {

using Eigen::VectorXd;

constexpr double moved_tol = 1e-9;             // relative to the diameter: nodes that move less count as not moved
constexpr double visible_step = 1e-8;          // relative to the diameter: no warning if the last step was shorter
constexpr double clearance_tol = 1e-6;         // relative: nodes that miss a clearance by less keep it
constexpr int iterations_between_scales = 30;  // then the length scales of the nodes are recomputed

/// The strength of the terms of walls is that of a pair of nodes at first, and four times as great in each next round.
constexpr double first_wall_strength = 2 * pi;
constexpr double stronger = 4;
constexpr int max_strengthenings = 8;

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
                  {energy, boundary, options.weight, free, {}, &face, options.walls, first_wall_strength},
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

/// Whether a placed node is nearer to a wall than its clearance.
bool has_crowded_node(const Problem& problem) {
  const std::vector<bool> is_near = nodes_near_walls(problem.face, problem.objective.walls, problem.points);
  return std::any_of(problem.coordinates.free.begin(), problem.coordinates.free.end(),
                     [&](int k) { return is_near[k]; });
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

/// As find_minimum, with walls so strong that all nodes keep their clearance, if they can.
Minimum find_minimum_clear_of_walls(Problem& problem, const PlacementOptions& options, Progress* progress) {
  Minimum result = find_minimum(problem, options, progress);
  for (int i = 0; i < max_strengthenings && has_crowded_node(problem); ++i) {
    problem.objective.wall_strength *= stronger;
    const Minimum next = find_minimum(problem, options, progress);
    const int iterations = result.iterations + next.iterations, evaluations = result.evaluations + next.evaluations;
    result = next;
    result.iterations = iterations, result.evaluations = evaluations;
  }
  return result;
}

std::string position_text(const CadFace& face, Vec2 x) { return quadrille::position_text(x + face.origin); }

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
    const Vec2 other = term.other ? nodes[*term.other].position : term.position;
    report.warn(warning::nodes_kept_apart,
                fmt::format("the node of valence {} at {} and the {} at {} attract each other and would meet: "
                            "they are kept {:.3g} apart",
                            nodes[term.node].valence, position_text(problem.face, nodes[term.node].position),
                            term.other ? "node" : "corner", position_text(problem.face, other), r));
  }
}

void warn_of_crowded_nodes(const Problem& problem, Report& report) {
  for (const int k : problem.coordinates.free)
    for (const WallClearance& wall : problem.objective.walls) {
      const CriticalPoint& node = problem.points.critical_points[k];
      Vec2 away;
      const double r = distance_to_wall(problem.face, wall, node.position, away);
      if (r >= wall.clearance * (1 - clearance_tol)) continue;
      report.warn(warning::clearance_missed,
                  fmt::format("the node of valence {} at {} is {:.3g} from a wall, less than its --clearance {:g}, and "
                              "has no more room: use a smaller clearance and thinner layers",
                              node.valence, position_text(problem.face, node.position), r, wall.clearance));
    }
}

void move_node(const CadFace& face, const PlacementOptions& options, Vec2 to, CriticalPoints& points, std::size_t k) {
  CriticalPoint& node = points.critical_points[k];
  const double way = distance(node.position, to);
  NodeChange change;
  change.kind = ChangeKind::place;
  change.reason = fmt::format("moved by {:.3g} to the least energy (weight of the boundary term {:g}{})", way,
                              options.weight, options.walls.empty() ? "" : ", with clearance for layers");
  change.before = {{node.position, node.valence, NodeLocation::inside}};
  change.after = {{to, node.valence, NodeLocation::inside}};
  node.position = to;
  if (way <= moved_tol * face.diameter) return;
  node.jacobian = {};
  node.error = 0;
  node.source = NodeSource::place;
  points.changes.push_back(change);
}

}  // namespace

void place_nodes(const CadFace& face, const EnergyFunction& energy, const std::vector<bool>& is_free,
                 const PlacementOptions& options, CriticalPoints& points, Report& report) {
  if (std::none_of(is_free.begin(), is_free.end(), [](bool free) { return free; })) return;
  const SmoothBoundaryDistance boundary(face);
  Problem problem = problem_of(face, energy, boundary, is_free, options, points);
  report.set("placement.energy_before", problem.objective.at(problem.points).value);
  const Minimum minimum = find_minimum_clear_of_walls(problem, options, report.progress());
  report_minimum(minimum, report);
  report.set("placement.symmetries", problem.group.size());
  warn_if_not_converged(minimum, report);
  warn_of_close_pairs(problem, report);
  warn_of_crowded_nodes(problem, report);

  const CriticalPoints before = points;
  for (std::size_t k = 0; k < is_free.size(); ++k)
    if (is_free[k]) move_node(face, options, problem.points.critical_points[k].position, points, k);
  if (points.changes.size() == before.changes.size()) {
    points = before;
    return;
  }
  if (points.form == NodeForm::harmonic && points.zeros.empty()) points.zeros = before.critical_points;
  points.form = NodeForm::phase;
}

}  // namespace quadrille::placement
