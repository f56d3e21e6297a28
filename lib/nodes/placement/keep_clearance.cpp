#include "placement/keep_clearance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/position_text.hpp"
#include "base/warning_codes.hpp"
#include "placement/node_room.hpp"
#include "placement/node_symmetry.hpp"
#include "placement/record_moves.hpp"

namespace quadrille::placement {
namespace {

constexpr double shortfall_tol = 1e-7;  // of the clearance: of the least shortfall where there is no room
constexpr double still = 1e-8;          // of the clearance: the rounds end when no node moves more
constexpr int max_rounds = 60;
constexpr double crowded = 0.1;  // nodes that miss more than this part of a clearance are reported

Vec2 next_step(const WallSurroundings& around, const MovingNode& moving, const CriticalPoints& points) {
  const Vec2 x = points.critical_points[moving.node].position;
  const NodeRoom room = around.room(moving, points);
  const Vec2 step =
      nearest_point_with_least_shortfall(room.planes, moving.start - x, moving.reach, shortfall_tol * moving.clearance);
  return norm(step) > room.longest_step ? room.longest_step * normalized(step) : step;
}

/// One round; whether no node moved.
bool move_all(const WallSurroundings& around, const std::vector<MovingNode>& moving, CriticalPoints& points) {
  bool is_still = true;
  std::vector<Vec2> steps;
  for (const MovingNode& node : moving) steps.push_back(next_step(around, node, points));
  for (std::size_t i = 0; i < moving.size(); ++i) {
    points.critical_points[moving[i].node].position += steps[i];
    if (norm(steps[i]) > still * moving[i].clearance) is_still = false;
  }
  return is_still;
}

void move_out(const CadFace& face, const WallSurroundings& around, const std::vector<MovingNode>& moving,
              CriticalPoints& points) {
  std::vector<bool> moves(points.critical_points.size(), false);
  for (const MovingNode& node : moving) moves[node.node] = true;
  const std::vector<NodeSymmetry> group = node_symmetries(face, points, moves);
  bool is_still = false;
  for (int round = 0; round < max_rounds && !is_still; ++round) {
    is_still = move_all(around, moving, points);
    symmetrise(group, moves, points);
  }
}

struct CrowdedNode {
  const CriticalPoint* node = nullptr;
  MissedClearance missed;
  double fraction = 0;  ///< of the clearance that it misses
};

/// The nodes that miss a notable part of a clearance, the one that misses most of it first.
std::vector<CrowdedNode> crowded_nodes(const WallSurroundings& around, const std::vector<MovingNode>& moving,
                                       const CriticalPoints& points) {
  std::vector<CrowdedNode> found;
  for (const MovingNode& m : moving) {
    const CriticalPoint& node = points.critical_points[m.node];
    const MissedClearance missed = around.missed(node.position);
    if (missed.curve < 0) continue;
    const double fraction = missed.shortfall / around.clearance(missed.curve);
    if (fraction > crowded) found.push_back({&node, missed, fraction});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const CrowdedNode& a, const CrowdedNode& b) { return a.fraction > b.fraction; });
  return found;
}

void report_crowded_nodes(const CadFace& face, const WallSurroundings& around, const std::vector<CrowdedNode>& nodes,
                          Report& report) {
  report.set("clearance.missed", nodes.size());
  if (nodes.empty()) return;
  const CrowdedNode& worst = nodes.front();
  const double clearance = around.clearance(worst.missed.curve);
  report.warn(
      warning::clearance_missed,
      fmt::format(
          "{} too little room for layers: that of valence {} at {} is {:.3g} from {}, where {:.3g} is best "
          "(--clearance; from quadmesh --wall twice the height of the layers and one more interval). If the layers do "
          "not fit, make them thinner, or give them blocks of their own (blocks=own)",
          nodes.size() == 1 ? "an irregular node has" : fmt::format("{} irregular nodes have", nodes.size()),
          worst.node->valence, position_text(worst.node->position + face.origin), clearance - worst.missed.shortfall,
          face.curve_names[worst.missed.curve], clearance));
}

}  // namespace

void keep_clearance(const CadFace& face, const std::vector<WallClearance>& walls, const std::vector<bool>& may_move,
                    CriticalPoints& points, Report& report) {
  if (walls.empty()) return;
  const WallSurroundings around(face, walls);
  const std::vector<MovingNode> moving = around.moving_nodes(may_move, points);
  report.set("clearance.moved", moving.size());
  if (moving.empty()) return;
  CriticalPoints moved = points;
  move_out(face, around, moving, moved);
  report_crowded_nodes(face, around, crowded_nodes(around, moving, moved), report);
  const auto reason = [](double way) {
    return fmt::format("moved by {:.3g}, the shortest way to its clearance for layers", way);
  };
  record_moves(face, moved, reason, points);
}

}  // namespace quadrille::placement
