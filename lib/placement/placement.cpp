#include "placement/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "placement/minimise.hpp"
#include "placement/node_guards.hpp"
#include "placement/node_symmetry.hpp"
#include "placement/wall_distance.hpp"

namespace quadrille::placement {

namespace {

using Eigen::VectorXd;

constexpr double moved_tol = 1e-9;             // of the diameter: nodes that move less have not moved
constexpr int iterations_between_scales = 30;  // after so many steps the nodes' length scales are taken anew

class Placement {
 public:
  Placement(const CadFace& face, const EnergyFunction& energy, const std::vector<bool>& is_free,
            const PlacementOptions& options, const CriticalPoints& points)
      : face_(face), energy_(energy), is_free_(is_free), options_(options), walls_(face), points_(points) {
    group_ = node_symmetries(face, points, is_free);
    symmetrise(group_, is_free, points_);
    movements_ = invariant_movements(group_, is_free);
    guards_ = node_guards(face, points_, is_free, options.pair_reach * face.diameter);
    for (std::size_t k = 0; k < is_free.size(); ++k)
      if (is_free[k]) free_.push_back(static_cast<int>(k));
  }

  // Node k = base + scale_k (movements y)_k, the scale its distance to the next wall or node: then all curvatures of
  // the function are of one size.
  Minimum run() {
    Minimum result;
    int iterations = 0, evaluations = 0;
    do {
      take_scales();
      MinimiseOptions options;
      options.tolerance = options_.tolerance;
      options.max_iterations = std::min(iterations_between_scales, options_.max_iterations - iterations);
      options.begins_with_hessian = iterations > 0;
      result = minimise(minimand(), VectorXd::Zero(movements_.cols()), options);
      points_ = placed(result.x);
      iterations += result.iterations;
      evaluations += result.evaluations;
      if (result.iterations < options.max_iterations) break;
    } while (!result.is_converged && iterations < options_.max_iterations);
    result.iterations = iterations;
    result.evaluations = evaluations;
    return result;
  }

  double value() const { return total(points_).value; }
  const CriticalPoints& points() const { return points_; }
  std::size_t num_symmetries() const { return group_.size(); }
  const std::vector<NodeGuard>& guards() const { return guards_; }

 private:
  NodeEnergy total(const CriticalPoints& points) const {
    NodeEnergy sum = energy_(points);
    for (const int k : free_) {
      const double d = 4 - points.critical_points[k].valence, share = options_.weight * pi * d * d;
      Vec2 slope;
      sum.value -= share * walls_.log_smooth(points.critical_points[k].position, slope);
      sum.gradient[k] -= share * slope;
    }
    for (const NodeGuard& guard : guards_) sum.value += guard_energy(guard, points, sum.gradient);
    return sum;
  }

  double distance_to_next(int node) const {
    const Vec2 x = points_.critical_points[node].position;
    double next = walls_.nearest(x);
    for (std::size_t j = 0; j < points_.critical_points.size(); ++j)
      if (static_cast<int>(j) != node) next = std::min(next, distance(points_.critical_points[j].position, x));
    return next;
  }

  void take_scales() {
    std::vector<double> own(is_free_.size()), mean(is_free_.size(), 0.0);
    for (const int k : free_) own[k] = distance_to_next(k);
    for (const NodeSymmetry& g : group_)
      for (const int k : free_) mean[g.image[k]] += own[k] / static_cast<double>(group_.size());
    scales_ = mean;
  }

  // Of all nodes; those that are not free do not move.
  std::vector<Vec2> movement(const VectorXd& y) const {
    const VectorXd scaled = movements_ * y;
    std::vector<Vec2> moves(is_free_.size());
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(2 * i);
      moves[free_[i]] = scales_[free_[i]] * Vec2{scaled[row], scaled[row + 1]};
    }
    return moves;
  }

  CriticalPoints placed(const VectorXd& y) const {
    CriticalPoints points = points_;
    const std::vector<Vec2> moves = movement(y);
    for (const int k : free_) points.critical_points[k].position += moves[k];
    return points;
  }

  std::optional<Minimand::Sample> sample(const VectorXd& y) const {
    NodeEnergy sum;
    try {
      sum = total(placed(y));
    } catch (const ComputeError&) {
      if (y.isZero(0)) throw;
      return std::nullopt;
    }
    VectorXd gradient(2 * free_.size());
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const Vec2 g = scales_[free_[i]] * sum.gradient[free_[i]];
      gradient.segment<2>(static_cast<Eigen::Index>(2 * i)) << g.x, g.y;
    }
    if (!std::isfinite(sum.value) || !gradient.allFinite()) return std::nullopt;
    return Minimand::Sample{sum.value, movements_.transpose() * gradient};
  }

  // No node comes nearer to a wall, another node or a corner that attracts it than half the way in one step.
  double allowed(const VectorXd& y, const VectorXd& step) const {
    const CriticalPoints points = placed(y);
    const std::vector<Vec2> moves = movement(step);
    double share = 1;
    const auto limit = [&](double way, double room) {
      if (way * share > room / 2) share = room / 2 / way;
    };
    const auto& nodes = points.critical_points;
    for (const int k : free_) {
      limit(norm(moves[k]), walls_.nearest(nodes[k].position));
      for (int j = 0; j < static_cast<int>(nodes.size()); ++j)
        if (j != k) limit(distance(moves[k], moves[j]), distance(nodes[k].position, nodes[j].position));
    }
    for (const NodeGuard& g : guards_)
      if (g.other < 0) limit(norm(moves[g.node]), guarded_distance(g, points));
    return share;
  }

  Minimand minimand() const {
    return {[this](const VectorXd& y) { return sample(y); },
            [this](const VectorXd& y, const VectorXd& step) { return allowed(y, step); },
            [this](const VectorXd& step) {
              double longest = 0;
              for (const Vec2 move : movement(step)) longest = std::max(longest, norm(move));
              return longest / face_.diameter;
            }};
  }

  const CadFace& face_;
  const EnergyFunction& energy_;
  const std::vector<bool>& is_free_;
  const PlacementOptions& options_;
  WallDistance walls_;
  CriticalPoints points_;
  std::vector<NodeSymmetry> group_;
  Eigen::MatrixXd movements_;
  std::vector<NodeGuard> guards_;
  std::vector<int> free_;
  std::vector<double> scales_;
};

std::string place_of(const CadFace& face, Vec2 x) {
  return fmt::format("({:.6g}, {:.6g})", x.x + face.origin.x, x.y + face.origin.y);
}

void warn_of_pairs(const CadFace& face, const Placement& placement, Report& report) {
  for (const NodeGuard& guard : placement.guards()) {
    const double r = guarded_distance(guard, placement.points());
    if (r >= guard.reach) continue;
    const auto& nodes = placement.points().critical_points;
    const Vec2 other = guard.other < 0 ? guard.place : nodes[guard.other].position;
    report.warn("W-PLACE-002",
                fmt::format("the node of valence {} at {} and the {} at {} attract each other and would meet; "
                            "they are kept {:.3g} apart",
                            nodes[guard.node].valence, place_of(face, nodes[guard.node].position),
                            guard.other < 0 ? "corner" : "node", place_of(face, other), r));
  }
}

void record_move(const CadFace& face, double weight, Vec2 to, CriticalPoints& points, std::size_t k) {
  CriticalPoint& node = points.critical_points[k];
  const double way = distance(node.position, to);
  NodeChange change;
  change.kind = ChangeKind::place;
  change.reason =
      fmt::format("moved by {:.3g} to the least energy (weight of the distance to the boundary {:g})", way, weight);
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

double log_wall_distance(const CadFace& face, Vec2 x, Vec2& gradient) {
  return WallDistance(face).log_smooth(x, gradient);
}

void place_nodes(const CadFace& face, const EnergyFunction& energy, const std::vector<bool>& is_free,
                 const PlacementOptions& options, CriticalPoints& points, Report& report) {
  if (std::none_of(is_free.begin(), is_free.end(), [](bool free) { return free; })) return;
  Placement placement(face, energy, is_free, options, points);
  report.set("placement.energy_before", placement.value());
  const Minimum minimum = placement.run();
  report.set("placement.energy_after", minimum.value);
  report.set("placement.iterations", minimum.iterations);
  report.set("placement.evaluations", minimum.evaluations);
  report.set("placement.last_step", minimum.last_step);
  report.set("placement.least_curvature", minimum.least_curvature);
  report.set("placement.symmetries", placement.num_symmetries());
  // The gradient's own noise is not the user's business as long as nobody sees it in the nodes.
  if (!minimum.is_converged && !(minimum.last_step > 0 && minimum.last_step <= 1e-8))
    report.warn("W-PLACE-001",
                fmt::format("the least energy was not found in {} steps; the nodes are on their way to it",
                            minimum.iterations));
  warn_of_pairs(face, placement, report);

  const CriticalPoints before = points;
  for (std::size_t k = 0; k < is_free.size(); ++k)
    if (is_free[k]) record_move(face, options.weight, placement.points().critical_points[k].position, points, k);
  if (points.changes.size() == before.changes.size()) {
    points = before;
    return;
  }
  if (points.form == NodeForm::harmonic && points.zeros.empty()) points.zeros = before.critical_points;
  points.form = NodeForm::phase;
}

}  // namespace quadrille::placement
