#include "features/separate_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "features/feature_state.hpp"

namespace quadrille::features {
namespace {

bool is_reflex_joint(const CadFace& face, int joint) {
  return face.joints[joint].interior_angle > pi + tolerance::same_angle;
}

bool turns_away(const CadFace& face, int curve, double t, bool from_left) {
  return curve::curvature(face.curves[curve], t, from_left) < -tolerance::tied / face.diameter;
}

/// Whether the boundary is reflex at the start of curve `joint`. At a smooth joint either side suffices: the end of a
/// fillet is reflex, though the straight side beyond it is not.
bool is_reflex_at_joint(const CadFace& face, int joint) {
  if (face.joints[joint].is_corner) return is_reflex_joint(face, joint);
  const int before = face.previous_in_loop(joint);
  return turns_away(face, joint, face.curves[joint].begin(), false) ||
         turns_away(face, before, face.curves[before].end(), true);
}

bool is_reflex(const CadFace& face, int curve, double t) {
  if (t <= face.curves[curve].begin()) return is_reflex_at_joint(face, curve);
  if (t >= face.curves[curve].end()) return is_reflex_at_joint(face, face.next_in_loop(curve));
  return turns_away(face, curve, t, false);
}

struct Push {
  std::vector<Vec2> moves;
  double shortfall = 0;  ///< greatest missing fraction of the spacing
};

/// Boundary nodes stay at their feature.
bool is_fixed_pair(const FeatureNode& a, const FeatureNode& b) { return !a.is_inside() && !b.is_inside(); }

void push_apart(const FeatureState& state, double spacing, Push& push) {
  const std::vector<FeatureNode>& nodes = state.nodes;
  for (size_t i = 0; i < nodes.size(); ++i) {
    for (size_t j = i + 1; j < nodes.size(); ++j) {
      const double d = distance(nodes[i].position, nodes[j].position);
      if (d >= spacing || d <= state.tie || is_fixed_pair(nodes[i], nodes[j])) continue;
      const Vec2 away = (nodes[i].position - nodes[j].position) / d;
      const double gap = spacing * (1 + feature_constants.push_margin) - d;
      const bool is_shared = nodes[i].is_inside() && nodes[j].is_inside();
      if (nodes[i].is_inside()) push.moves[i] += (is_shared ? gap / 2 : gap) * away;
      if (nodes[j].is_inside()) push.moves[j] -= (is_shared ? gap / 2 : gap) * away;
      push.shortfall = std::max(push.shortfall, 1 - d / spacing);
    }
  }
}

void push_off_boundary(const FeatureState& state, const curve::FaceBoundary& boundary, double spacing, Push& push) {
  for (size_t i = 0; i < state.nodes.size(); ++i) {
    const FeatureNode& node = state.nodes[i];
    if (!node.is_inside() || !node.is_changed()) continue;
    for (const CurveFoot& foot : feet_of(boundary, node.position, spacing)) {
      if (foot.is_reflex || foot.distance <= 0) continue;
      push.moves[i] += (spacing * (1 + feature_constants.push_margin) - foot.distance) / foot.distance *
                       (node.position - foot.position);
      push.shortfall = std::max(push.shortfall, 1 - foot.distance / spacing);
    }
  }
}

/// Reflex boundary does not push, because nodes of valence 5 belong near it; but none is pushed onto it.
void keep_off_reflex_boundary(const FeatureState& state, const curve::FaceBoundary& boundary,
                              const std::vector<double>& least_clearance, Push& push) {
  for (size_t i = 0; i < state.nodes.size(); ++i) {
    Vec2& move = push.moves[i];
    if (norm(move) == 0) continue;
    for (const CurveFoot& foot : feet_of(boundary, state.nodes[i].position, least_clearance[i])) {
      const Vec2 away = normalized(state.nodes[i].position - foot.position);
      if (foot.is_reflex && dot(move, away) < 0) move -= dot(move, away) * away;
    }
  }
}

Push pushes(const FeatureState& state, const curve::FaceBoundary& boundary, double spacing,
            const std::vector<double>& least_clearance) {
  Push push{std::vector<Vec2>(state.nodes.size()), 0};
  push_apart(state, spacing, push);
  push_off_boundary(state, boundary, spacing, push);
  keep_off_reflex_boundary(state, boundary, least_clearance, push);
  return push;
}

/// Of each node, its distance to the boundary at first, but no more than the spacing.
std::vector<double> least_clearances(const FeatureState& state, const curve::FaceBoundary& boundary, double spacing) {
  std::vector<double> least;
  for (const FeatureNode& node : state.nodes)
    least.push_back(node.is_inside() ? std::min(spacing, boundary.nearest(node.position).distance) : 0);
  return least;
}

/// Carries out one round. No node moves farther than half of its clearance.
void apply(const Push& push, const curve::FaceBoundary& boundary, FeatureState& state) {
  for (size_t i = 0; i < state.nodes.size(); ++i) {
    const double length = norm(push.moves[i]);
    if (length == 0) continue;
    const double step =
        std::min(feature_constants.push_step * length,
                 feature_constants.push_to_boundary * boundary.nearest(state.nodes[i].position).distance);
    state.nodes[i].position += step / length * push.moves[i];
    state.nodes[i].changed_by = ChangeKind::feature;
  }
}

/// Keeps the round with the least shortfall; stops as soon as there is no shortfall.
void push_to_spacing(FeatureState& state, const curve::FaceBoundary& boundary, double spacing) {
  const std::vector<double> least_clearance = least_clearances(state, boundary, spacing);
  std::vector<FeatureNode> best = state.nodes;
  Push push = pushes(state, boundary, spacing, least_clearance);
  double least = push.shortfall;
  for (int round = 0; round < feature_constants.max_push_rounds && push.shortfall > 0; ++round) {
    apply(push, boundary, state);
    push = pushes(state, boundary, spacing, least_clearance);
    if (push.shortfall >= least) continue;
    least = push.shortfall;
    best = state.nodes;
  }
  state.nodes = best;
}

void record_moves(FeatureState& state, const std::vector<FeatureNode>& before, double spacing) {
  for (size_t i = 0; i < before.size(); ++i) {
    const double moved = distance(before[i].position, state.nodes[i].position);
    if (moved > 0)
      record(state, ChangeKind::feature, {before[i]}, {state.nodes[i]},
             fmt::format("moved by {:.4g}, to be half the feature size, {:.4g}, away from nodes and boundary", moved,
                         spacing));
  }
}

void record_close_pairs(FeatureState& state, double spacing) {
  const std::vector<FeatureNode> nodes = state.nodes;
  for (size_t i = 0; i < nodes.size(); ++i) {
    for (size_t j = i + 1; j < nodes.size(); ++j) {
      const double d = distance(nodes[i].position, nodes[j].position);
      const bool is_one_hole = nodes[i].hole && nodes[i].hole == nodes[j].hole;
      if (d >= spacing * (1 - tolerance::round_off) || (is_one_hole && is_fixed_pair(nodes[i], nodes[j]))) continue;
      record(state, ChangeKind::feature, {nodes[i], nodes[j]}, {nodes[i], nodes[j]},
             fmt::format("two nodes stay {:.4g} apart, less than half the feature size, {:.4g}: there is no room", d,
                         spacing));
    }
  }
}

void record_close_to_boundary(FeatureState& state, const curve::FaceBoundary& boundary, double spacing) {
  const std::vector<FeatureNode> nodes = state.nodes;
  const double enough = spacing * (1 - tolerance::round_off);
  for (const FeatureNode& node : nodes) {
    if (!node.is_inside() || !node.is_changed()) continue;
    double nearest = enough;
    for (const CurveFoot& foot : feet_of(boundary, node.position, nearest))
      if (!foot.is_reflex) nearest = std::min(nearest, foot.distance);
    if (nearest < enough)
      record(state, ChangeKind::feature, {node}, {node},
             fmt::format("the node stays {:.4g} from the boundary, less than half the feature size, {:.4g}: there is "
                         "no room",
                         nearest, spacing));
  }
}

}  // namespace

std::vector<CurveFoot> feet_of(const curve::FaceBoundary& boundary, Vec2 x, double reach) {
  std::vector<CurveFoot> feet;
  for (const curve::NearestPoint& p : boundary.feet_within(x, reach)) {
    const bool is_known = std::any_of(feet.begin(), feet.end(), [&](const CurveFoot& foot) {
      return distance(foot.position, p.position) <= tolerance::same_point * boundary.face().diameter;
    });
    if (p.distance < reach && !is_known)
      feet.push_back({p.position, p.distance, is_reflex(boundary.face(), p.curve, p.t)});
  }
  return feet;
}

void separate_nodes(FeatureState& state, const curve::FaceBoundary& boundary) {
  const double spacing = feature_constants.spacing * state.size;
  const std::vector<FeatureNode> before = state.nodes;
  push_to_spacing(state, boundary, spacing);
  record_moves(state, before, spacing);
  record_close_pairs(state, spacing);
  record_close_to_boundary(state, boundary, spacing);
}

}  // namespace quadrille::features
