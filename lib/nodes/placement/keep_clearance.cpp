#include "placement/keep_clearance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/number_list.hpp"
#include "base/tolerance.hpp"
#include "base/warning_codes.hpp"
#include "curve/face_boundary.hpp"
#include "curve/named_places.hpp"
#include "curve/project.hpp"
#include "placement/axis_pairs.hpp"
#include "placement/half_planes.hpp"
#include "placement/node_ledger.hpp"
#include "placement/node_symmetry.hpp"
#include "surface/positions.hpp"

namespace quadrille::placement {
namespace {

struct ClearanceRules {
  double greatest_step = 0.5;   ///< of the distance to the nearest obstacle
  double kept_fraction = 0.5;   ///< of distances to other nodes and to boundaries without layers
  double shortfall_tol = 1e-7;  ///< of the clearance: of the least shortfall where there is no room
  double still = 1e-8;          ///< of the clearance: the rounds end when no node moves more
  int max_rounds = 60;
  double crowded = 0.1;  ///< nodes that miss more than this part of a clearance are reported
};
constexpr ClearanceRules rules;

/// The clearances that a point misses, by more than 1e-6 of them.
struct MissedClearance {
  int curve = -1;        ///< the one that it misses by most; -1: it keeps all
  double shortfall = 0;  ///< by which it misses that one
  double greatest = 0;   ///< of the clearances that it misses
};

/// Part of a curve to which a node keeps a distance of `least`.
struct Obstacle {
  int curve = 0;
  double t0 = 0, t1 = 0;
  double least = 0;
  bool is_wall = false;
};

/// Another node to which a node keeps a distance of `least`.
struct Neighbour {
  int node = 0;
  double least = 0;
  bool moves = false;
};

struct MovingNode {
  int node = 0;
  Vec2 start;
  double clearance = 0;  ///< the greatest that it misses at the start
  double reach = 0;      ///< the greatest distance from the start, in space: the greatest shortfall there
  std::vector<Obstacle> obstacles;
  std::vector<Neighbour> neighbours;
};

/// The half planes of the steps with which a node keeps its distances, to first order.
struct NodeRoom {
  std::vector<HalfPlane> planes;
  double reach = 0;                ///< the greatest distance from the start
  double longest_step = HUGE_VAL;  ///< half of the distance to the nearest obstacle
};

/// The nodes to which each of the moving nodes may come too near: all where reaches are no lengths of the plane.
void find_neighbours(const CriticalPoints& points, bool is_chart, std::vector<MovingNode>& moving) {
  std::vector<const MovingNode*> by_node(points.critical_points.size(), nullptr);
  for (const MovingNode& node : moving) by_node[node.node] = &node;
  for (MovingNode& node : moving)
    for (int j = 0; j < static_cast<int>(by_node.size()); ++j) {
      if (j == node.node) continue;
      const double other_reach = by_node[j] ? by_node[j]->reach : 0;
      const double d = distance(points.critical_points[j].position, node.start);
      const double least = rules.kept_fraction * d;
      if (is_chart || d - least < node.reach + other_reach)
        node.neighbours.push_back({j, least, by_node[j] != nullptr});
    }
}

/// The boundary curves and other nodes to which nodes keep a distance. Clearances above the mean width of a planar face
/// count as that much.
class WallSurroundings {
 public:
  WallSurroundings(const CadFace& face, const std::vector<WallClearance>& walls, const LogScale& log_scale)
      : boundary_(face), clearance_(clearance_of_curves(face, walls)), log_scale_(log_scale) {
    if (log_scale_) return;
    mean_width_ = curve::mean_width(face);
    greatest_ = *std::ranges::max_element(clearance_);
  }

  double clearance(int curve) const { return clearance_[curve]; }
  const curve::FaceBoundary& boundary() const { return boundary_; }

  MissedClearance missed(Vec2 x) const {
    MissedClearance result;
    const auto is_wall = [&](int c) { return clearance_[c] > 0; };
    for (const auto& [c, t, foot, in_plane] : boundary_.feet_within(x, greatest_, is_wall)) {
      const double r = in_plane * mean_scale(x, foot);
      if (r >= clearance_[c] * (1 - tolerance::tied)) continue;
      if (clearance_[c] - r > result.shortfall) result.curve = c, result.shortfall = clearance_[c] - r;
      result.greatest = std::max(result.greatest, clearance_[c]);
    }
    return result;
  }

  /// The nodes with may_move[k] that miss a clearance, each with what it may come too near to within its reach.
  std::vector<MovingNode> moving_nodes(const std::vector<bool>& may_move, const CriticalPoints& points) const {
    std::vector<MovingNode> moving;
    for (std::size_t k = 0; k < may_move.size(); ++k) {
      const Vec2 start = points.critical_points[k].position;
      const MissedClearance missed = may_move[k] ? this->missed(start) : MissedClearance();
      if (missed.curve < 0) continue;
      moving.push_back({static_cast<int>(k), start, missed.greatest, std::min(missed.shortfall, mean_width_), {}, {}});
      add_obstacles(moving.back());
    }
    find_neighbours(points, log_scale_ != nullptr, moving);
    return moving;
  }

  /// The room of a node at its position of `points`, without what no point within the reach misses. Two nodes that move
  /// share what is between them.
  NodeRoom room(const MovingNode& moving, const CriticalPoints& points) const {
    const Vec2 x = points.critical_points[moving.node].position;
    const double moved = distance(moving.start, x), scale = mean_scale(x, x);
    NodeRoom room{{}, moving.reach / mean_scale(moving.start, x)};
    if (log_scale_) room.reach = std::max(room.reach, moved);
    const double farthest = room.reach + moved;
    for (const Obstacle& o : moving.obstacles) {
      const curve::Projection foot = curve::project(boundary_.face().curves[o.curve], x, o.t0, o.t1);
      const double bound =
          o.is_wall ? (o.least - foot.distance * mean_scale(x, foot.position)) / scale : o.least - foot.distance;
      if (bound < -farthest) continue;
      room.longest_step = std::min(room.longest_step, rules.greatest_step * foot.distance);
      room.planes.push_back({(x - foot.position) / foot.distance, bound, o.is_wall});
    }
    for (const Neighbour& other : moving.neighbours) {
      const Vec2 between = x - points.critical_points[other.node].position;
      const double d = norm(between), bound = (other.least - d) * (other.moves ? 0.5 : 1);
      if (bound >= -farthest) room.planes.push_back({between / d, bound, false});
    }
    return room;
  }

 private:
  /// A length in space over that of the straight line from a to b.
  double mean_scale(Vec2 a, Vec2 b) const { return placement::mean_scale(log_scale_, boundary_, a, b); }

  /// Each knot span has a nearest point of its own, so that a curve which surrounds the node does so from all sides.
  void add_obstacles(MovingNode& moving) const {
    const double greatest = std::max(std::min(greatest_, mean_width_), moving.reach) + moving.reach;
    for (const curve::NearestPoint& near : boundary_.feet_within(moving.start, greatest)) {
      const int c = near.curve;
      const std::vector<double>& knots = boundary_.face().curves[c].knots;
      const bool is_wall = clearance_[c] > 0;
      for (std::size_t i = 1; i < knots.size(); ++i) {
        if (knots[i - 1] >= knots[i]) continue;
        const double r = curve::project(boundary_.face().curves[c], moving.start, knots[i - 1], knots[i]).distance;
        const double least = is_wall ? std::min(clearance_[c], mean_width_) : rules.kept_fraction * r;
        if (log_scale_ || r < least + moving.reach)
          moving.obstacles.push_back({c, knots[i - 1], knots[i], least, is_wall});
      }
    }
  }

  curve::FaceBoundary boundary_;
  std::vector<double> clearance_;  ///< by curve; 0: no wall
  const LogScale& log_scale_;
  double mean_width_ = HUGE_VAL, greatest_ = HUGE_VAL;  ///< not known of surfaces; greatest clearance
};

Vec2 next_step(const WallSurroundings& around, const MovingNode& moving, const CriticalPoints& points) {
  const Vec2 x = points.critical_points[moving.node].position;
  const NodeRoom room = around.room(moving, points);
  const Vec2 step = nearest_point_with_least_shortfall(room.planes, moving.start - x, room.reach,
                                                       rules.shortfall_tol * moving.clearance);
  return norm(step) > room.longest_step ? room.longest_step * normalized(step) : step;
}

/// One round; whether no node moved.
bool move_all(const WallSurroundings& around, const std::vector<MovingNode>& moving, CriticalPoints& points) {
  bool is_still = true;
  std::vector<Vec2> steps;
  for (const MovingNode& node : moving) steps.push_back(next_step(around, node, points));
  for (std::size_t i = 0; i < moving.size(); ++i) {
    points.critical_points[moving[i].node].position += steps[i];
    if (norm(steps[i]) > rules.still * moving[i].clearance) is_still = false;
  }
  return is_still;
}

void move_out(const CadFace& face, const WallSurroundings& around, const std::vector<MovingNode>& moving,
              CriticalPoints& points) {
  std::vector<bool> moves(points.critical_points.size(), false);
  for (const MovingNode& node : moving) moves[node.node] = true;
  const std::vector<NodeSymmetry> group = node_symmetries(face, points, moves);
  bool is_still = false;
  for (int round = 0; round < rules.max_rounds && !is_still; ++round) {
    is_still = move_all(around, moving, points);
    symmetrise(group, moves, points);
  }
}

struct CrowdedNode {
  int node = 0;
  MissedClearance missed;
  double fraction = 0;  ///< of the clearance that it misses
};

/// The nodes that miss a notable part of a clearance, the one that misses most of it first.
std::vector<CrowdedNode> crowded_nodes(const WallSurroundings& around, const std::vector<MovingNode>& moving,
                                       const CriticalPoints& points) {
  std::vector<CrowdedNode> found;
  for (const MovingNode& m : moving) {
    const MissedClearance missed = around.missed(points.critical_points[m.node].position);
    if (missed.curve < 0) continue;
    const double fraction = missed.shortfall / around.clearance(missed.curve);
    if (fraction > rules.crowded) found.push_back({m.node, missed, fraction});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const CrowdedNode& a, const CrowdedNode& b) { return a.fraction > b.fraction; });
  return found;
}

/// The nodes before and after they move out, and those that still miss a clearance.
struct Attempt {
  CriticalPoints start, moved;
  std::vector<MovingNode> moving;
  std::vector<CrowdedNode> crowded;

  double missed() const {
    double sum = 0;
    for (const CrowdedNode& node : crowded) sum += node.fraction;
    return sum;
  }
};

Attempt attempt_from(const CadFace& face, const WallSurroundings& around, const std::vector<bool>& may_move,
                     const CriticalPoints& start) {
  Attempt attempt{start, start, around.moving_nodes(may_move, start), {}};
  if (attempt.moving.empty()) return attempt;
  move_out(face, around, attempt.moving, attempt.moved);
  attempt.crowded = crowded_nodes(around, attempt.moving, attempt.moved);
  return attempt;
}

/// The same with the pairs turned that have too little room on a mirror axis and more beside it.
Attempt best_attempt(const CadFace& face, const WallSurroundings& around, const std::vector<bool>& may_move,
                     Attempt best) {
  for (bool is_better = true; is_better && !best.crowded.empty();) {
    is_better = false;
    std::vector<bool> is_stuck(may_move.size(), false);
    for (const CrowdedNode& node : best.crowded) is_stuck[node.node] = true;
    const std::vector<NodeSymmetry> group = node_symmetries(face, best.start, may_move);
    for (const CriticalPoints& turned : with_turned_pairs(around.boundary(), group, may_move, is_stuck, best.start)) {
      Attempt next = attempt_from(face, around, may_move, turned);
      if (next.missed() >= best.missed() - tolerance::tied) continue;
      best = std::move(next);
      is_better = true;
    }
  }
  return best;
}

void report_crowded_nodes(const CadFace& face, const WallSurroundings& around, const Attempt& attempt, Report& report) {
  report.set("clearance.missed", attempt.crowded.size());
  if (attempt.crowded.empty()) return;
  const CrowdedNode& worst = attempt.crowded.front();
  const CriticalPoint& node = attempt.moved.critical_points[worst.node];
  const double clearance = around.clearance(worst.missed.curve);
  report.warn(
      warning::clearance_missed,
      fmt::format(
          "{} too little room for layers: that of valence {} at {} is {:.3g} from {}, where {:.3g} is best "
          "(--clearance; from quadmesh --wall twice the height of the layers and one more interval). If the layers do "
          "not fit, make them thinner, or give them blocks of their own (blocks=own)",
          attempt.crowded.size() == 1 ? "an irregular node has"
                                      : fmt::format("{} irregular nodes have", attempt.crowded.size()),
          node.valence, surface::position_text(face, node.position), clearance - worst.missed.shortfall,
          face.curve_names[worst.missed.curve], clearance));
}

}  // namespace

NamedClearance parse_clearance(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  NamedClearance result;
  if (equals != std::string::npos) {
    result.name = text.substr(0, equals);
    result.clearance = finite_number_of(text.substr(equals + 1)).value_or(0);
  }
  if (result.name.empty() || !(result.clearance > 0))
    throw UsageError(fmt::format("--clearance: '{}' is not NAME=L with a length L > 0", text));
  return result;
}

std::vector<WallClearance> wall_clearances(const CadFace& face, const std::vector<NamedClearance>& named) {
  std::vector<WallClearance> walls;
  walls.reserve(named.size());
  for (const NamedClearance& one : named)
    walls.push_back({curve::named_curves(face, one.name, "--clearance"), one.clearance});
  return walls;
}

std::vector<double> clearance_of_curves(const CadFace& face, const std::vector<WallClearance>& walls) {
  std::vector<double> clearance(face.curves.size(), 0.0);
  for (const WallClearance& wall : walls)
    for (const int curve : wall.curves) clearance[curve] = std::max(clearance[curve], wall.clearance);
  return clearance;
}

void keep_clearance(const CadFace& face, const std::vector<WallClearance>& walls, const LogScale& log_scale,
                    const std::vector<bool>& may_move, CriticalPoints& points, Report& report) {
  if (walls.empty()) return;
  const WallSurroundings around(face, walls, log_scale);
  const Attempt on_axes = attempt_from(face, around, may_move, points);
  report.set("clearance.moved", on_axes.moving.size());
  if (on_axes.moving.empty()) return;
  const Attempt best = best_attempt(face, around, may_move, on_axes);
  report_crowded_nodes(face, around, best, report);
  record_moves(
      face, best.start,
      [](double way) {
        return fmt::format("moved by {:.3g}, with its neighbour to both sides of a mirror axis, which has no room",
                           way);
      },
      points);
  record_moves(
      face, best.moved,
      [](double way) { return fmt::format("moved by {:.3g}, the shortest way to its clearance for layers", way); },
      points);
}

}  // namespace quadrille::placement
