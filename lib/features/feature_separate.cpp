#include "features/feature_separate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace quadrille::features {
namespace {

constexpr int max_rounds = 400;
constexpr double margin = 1e-3;  // of the distance asked for: where the pushing aims beyond it

struct Push {
  std::vector<Vec2> moves;
  double lack = 0;  ///< greatest part of the distance asked for that is missing
};

/// Boundary nodes stay where their feature is.
bool is_fixed_pair(const FeatureNode& a, const FeatureNode& b) { return !a.is_inside() && !b.is_inside(); }

void push_nodes(const FeatureNodes& state, double apart, Push& push) {
  const std::vector<FeatureNode>& nodes = state.nodes;
  for (size_t i = 0; i < nodes.size(); ++i) {
    for (size_t j = i + 1; j < nodes.size(); ++j) {
      const double d = distance(nodes[i].position, nodes[j].position);
      if (d >= apart || d <= state.tie || is_fixed_pair(nodes[i], nodes[j])) continue;
      const Vec2 away = (nodes[i].position - nodes[j].position) / d;
      const double gap = apart * (1 + margin) - d;
      const bool is_shared = nodes[i].is_inside() && nodes[j].is_inside();
      if (nodes[i].is_inside()) push.moves[i] += (is_shared ? gap / 2 : gap) * away;
      if (nodes[j].is_inside()) push.moves[j] -= (is_shared ? gap / 2 : gap) * away;
      push.lack = std::max(push.lack, 1 - d / apart);
    }
  }
}

void push_off_walls(const FeatureNodes& state, const Walls& walls, double apart, Push& push) {
  for (size_t i = 0; i < state.nodes.size(); ++i) {
    const FeatureNode& node = state.nodes[i];
    if (!node.is_inside() || !node.is_changed()) continue;
    for (const WallFoot& foot : walls.feet(node.position, apart)) {
      if (foot.is_reflex || foot.distance <= 0) continue;
      push.moves[i] += (apart * (1 + margin) - foot.distance) / foot.distance * (node.position - foot.position);
      push.lack = std::max(push.lack, 1 - foot.distance / apart);
    }
  }
}

Push pushes(const FeatureNodes& state, const Walls& walls, double apart) {
  Push push{std::vector<Vec2>(state.nodes.size()), 0};
  push_nodes(state, apart, push);
  push_off_walls(state, walls, apart, push);
  return push;
}

/// One round, all nodes at once, so that symmetric sets stay symmetric; never farther than half the way to a wall.
void apply(const Push& push, const Walls& walls, FeatureNodes& state) {
  for (size_t i = 0; i < state.nodes.size(); ++i) {
    const double length = norm(push.moves[i]);
    if (length == 0) continue;
    const double step = std::min(0.5 * length, 0.5 * walls.distance_to(state.nodes[i].position));
    state.nodes[i].position += step / length * push.moves[i];
    state.nodes[i].changed_by = ChangeKind::feature;
  }
}

void record_moves(FeatureNodes& state, const std::vector<FeatureNode>& before, double apart) {
  for (size_t i = 0; i < before.size(); ++i) {
    const double moved = distance(before[i].position, state.nodes[i].position);
    if (moved > 0)
      record(state, ChangeKind::feature, {before[i]}, {state.nodes[i]},
             fmt::format("pushed by {:.4g}, to be half the feature size, {:.4g}, away from nodes and walls", moved,
                         apart));
  }
}

void record_left(FeatureNodes& state, double apart) {
  const std::vector<FeatureNode> nodes = state.nodes;
  for (size_t i = 0; i < nodes.size(); ++i) {
    for (size_t j = i + 1; j < nodes.size(); ++j) {
      const double d = distance(nodes[i].position, nodes[j].position);
      const bool is_one_hole = nodes[i].hole >= 0 && nodes[i].hole == nodes[j].hole;
      if (d >= apart * (1 - 1e-9) || (is_one_hole && is_fixed_pair(nodes[i], nodes[j]))) continue;
      record(state, ChangeKind::feature, {nodes[i], nodes[j]}, {nodes[i], nodes[j]},
             fmt::format("left {:.4g} apart, nearer than half the feature size, {:.4g}: there is no room", d, apart));
    }
  }
}

void record_near_walls(FeatureNodes& state, const Walls& walls, double apart) {
  const std::vector<FeatureNode> nodes = state.nodes;
  for (const FeatureNode& node : nodes) {
    if (!node.is_inside() || !node.is_changed()) continue;
    double nearest = apart * (1 - 1e-9);
    for (const WallFoot& foot : walls.feet(node.position, nearest))
      if (!foot.is_reflex) nearest = std::min(nearest, foot.distance);
    if (nearest < apart * (1 - 1e-9))
      record(state, ChangeKind::feature, {node}, {node},
             fmt::format("left {:.4g} off a wall, nearer than half the feature size, {:.4g}: there is no room", nearest,
                         apart));
  }
}

}  // namespace

void separate(FeatureNodes& state, const Walls& walls) {
  const double apart = state.size / 2;
  const std::vector<FeatureNode> before = state.nodes;
  std::vector<FeatureNode> best = before;
  Push push = pushes(state, walls, apart);
  double least = push.lack;
  for (int round = 0; round < max_rounds && push.lack > 0; ++round) {
    apply(push, walls, state);
    push = pushes(state, walls, apart);
    if (push.lack >= least) continue;
    least = push.lack;
    best = state.nodes;
  }
  state.nodes = best;
  record_moves(state, before, apart);
  record_left(state, apart);
  record_near_walls(state, walls, apart);
}

}  // namespace quadrille::features
