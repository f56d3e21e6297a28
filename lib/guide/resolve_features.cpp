// A node of index +-1 belongs to the nearest small feature (guide/feature_bends) that carries an index of its sign and
// is nearer than L; one with two features equally near belongs to neither. A feature takes no more nodes than it
// carries, nearest first, nodes equally near together or not at all.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "guide/feature_bends.hpp"
#include "guide/feature_cancel.hpp"
#include "guide/feature_inward.hpp"
#include "guide/feature_separate.hpp"
#include "guide/resolve.hpp"

namespace quadrille {
namespace {

struct Claim {
  int node = 0;
  StretchFoot foot;
};

FeatureNodes nodes_of(const CadFace& face, double size, const CriticalPoints& points) {
  FeatureNodes state;
  state.size = size;
  state.tie = 1e-6 * face.diameter;
  for (size_t i = 0; i < points.critical_points.size(); ++i) {
    const CriticalPoint& p = points.critical_points[i];
    state.nodes.push_back({p.position, p.valence, -1, 0, static_cast<int>(i), -1, {}});
  }
  for (size_t i = 0; i < points.boundary_nodes.size(); ++i) {
    const IrregularBoundaryPoint& b = points.boundary_nodes[i];
    state.nodes.push_back({b.position, b.valence, b.curve, b.t, static_cast<int>(i), -1, {}});
  }
  return state;
}

/// The feature that `node` belongs to, -1: none.
int owner(const FeatureNodes& state, const std::vector<SmallFeature>& features, const FeatureNode& node,
          StretchFoot& foot) {
  int nearest = -1;
  bool is_tied = false;
  for (size_t f = 0; f < features.size(); ++f) {
    if ((features[f].kind == FeatureKind::convex) != (node.index() > 0)) continue;
    const StretchFoot here = features[f].stretch.foot(node.position);
    if (here.distance >= state.size - state.tie) continue;
    if (nearest >= 0 && here.distance > foot.distance - state.tie) {
      // A hole's own bends come first: they are part of it.
      is_tied |= here.distance < foot.distance + state.tie && distance(here.position, foot.position) > state.tie;
      continue;
    }
    nearest = static_cast<int>(f);
    foot = here;
    is_tied = false;
  }
  return is_tied ? -1 : nearest;
}

/// As many as the feature carries; nodes of equal distance together or not at all.
void keep_carried(const FeatureNodes& state, size_t capacity, std::vector<Claim>& claims) {
  std::stable_sort(claims.begin(), claims.end(),
                   [](const Claim& a, const Claim& b) { return a.foot.distance < b.foot.distance; });
  if (claims.size() <= capacity) return;
  size_t kept = capacity;
  while (kept > 0 && claims[kept].foot.distance - claims[kept - 1].foot.distance <= state.tie) --kept;
  claims.resize(kept);
}

std::vector<std::vector<Claim>> claims_of(const FeatureNodes& state, const std::vector<SmallFeature>& features) {
  std::vector<std::vector<Claim>> claims(features.size());
  for (size_t i = 0; i < state.nodes.size(); ++i) {
    const FeatureNode& node = state.nodes[i];
    StretchFoot foot;
    if (!node.is_inside() || std::abs(node.index()) != 1) continue;
    if (const int f = owner(state, features, node, foot); f >= 0) claims[f].push_back({static_cast<int>(i), foot});
  }
  for (size_t f = 0; f < features.size(); ++f) keep_carried(state, features[f].capacity, claims[f]);
  return claims;
}

/// Evenly over an open stretch, or over a closed one with the mean offset that `wanted` (ascending) has.
std::vector<double> even_fractions(const std::vector<double>& wanted, bool is_closed) {
  const double n = static_cast<double>(wanted.size());
  double offset = 0.5 / n;
  if (is_closed) {
    offset = 0;
    for (size_t i = 0; i < wanted.size(); ++i) offset += (wanted[i] - static_cast<double>(i) / n) / n;
  }
  std::vector<double> even;
  for (size_t i = 0; i < wanted.size(); ++i) even.push_back(offset + static_cast<double>(i) / n);
  return even;
}

/// Where nodes go on their feature: the middle where the feature is made for one, else their feet, kept off each other
/// and off the ends.
std::vector<double> fractions_on(const SmallFeature& feature, const std::vector<Claim>& claims) {
  const bool is_closed = feature.stretch.is_closed();
  if (!is_closed && claims.size() == 1 && feature.capacity == 1) return {0.5};
  const double least = 0.5 / static_cast<double>(claims.size());
  std::vector<double> wanted;
  for (const Claim& claim : claims) wanted.push_back(claim.foot.fraction);
  bool is_crowded = false;
  for (size_t i = 0; i + 1 < wanted.size(); ++i) is_crowded |= wanted[i + 1] - wanted[i] < least;
  if (is_closed && wanted.size() > 1) is_crowded |= wanted.front() + 1 - wanted.back() < least;
  if (!is_closed) is_crowded |= wanted.front() < least / 2 || wanted.back() > 1 - least / 2;
  return is_crowded ? even_fractions(wanted, is_closed) : wanted;
}

std::string reason(const FeatureNodes& state, const SmallFeature& feature, double distance) {
  const std::string what = feature.kind == FeatureKind::hole
                               ? fmt::format("a hole of diameter {:.4g}", feature.extent)
                               : fmt::format("a reflex fillet of radius {:.4g}", feature.extent);
  return fmt::format("{} is below the feature size {:.4g}: a node of valence 5 goes onto it, from {:.4g} away", what,
                     state.size, distance);
}

void put_onto(FeatureNodes& state, const SmallFeature& feature, int id, std::vector<Claim> claims) {
  std::stable_sort(claims.begin(), claims.end(),
                   [](const Claim& a, const Claim& b) { return a.foot.fraction < b.foot.fraction; });
  const std::vector<double> fractions = fractions_on(feature, claims);
  for (size_t i = 0; i < claims.size(); ++i) {
    const BoundaryPlace place = feature.stretch.at(fractions[i]);
    FeatureNode& node = state.nodes[claims[i].node];
    const FeatureNode before = node;
    node = {place.position, 3, place.curve, place.t, before.source, id, "feature"};
    record(state, "feature", {before}, {node}, reason(state, feature, claims[i].foot.distance));
  }
}

/// Along the bend's bisector where it is made for one node, else away from the node's own foot.
InwardMove inward_move(const CadFace& face, const FeatureNode& node, const SmallFeature& feature, const Claim& claim) {
  if (feature.capacity > 1)
    return {claim.node, node.position, normalized(node.position - claim.foot.position), feature.extent};
  const BoundaryPlace middle = feature.stretch.at(0.5);
  const Vec2 inward = left_of(tangent(face.curves[middle.curve], middle.t));
  return {claim.node, middle.position + dot(node.position - middle.position, inward) * inward, inward, feature.extent};
}

void move_to_features(const CadFace& face, const Walls& walls, FeatureNodes& state) {
  const std::vector<SmallFeature> features = small_features(face, state.size);
  const std::vector<std::vector<Claim>> claims = claims_of(state, features);
  std::vector<InwardMove> moves;
  for (size_t f = 0; f < features.size(); ++f) {
    if (claims[f].empty()) continue;
    if (features[f].kind != FeatureKind::convex) {
      put_onto(state, features[f], static_cast<int>(f), claims[f]);
      continue;
    }
    for (const Claim& claim : claims[f])
      moves.push_back(inward_move(face, state.nodes[claim.node], features[f], claim));
  }
  move_inward(state, walls, moves);
}

CriticalPoint inner_point(const CriticalPoints& points, const FeatureNode& node) {
  CriticalPoint point = points.critical_points[node.source];
  if (!node.is_changed()) return point;
  point.position = node.position;
  point.valence = node.valence;
  point.index = 4 - node.valence;
  point.jacobian = {};
  point.error = 0;
  point.source = node.changed_by;
  return point;
}

void write_back(const FeatureNodes& state, CriticalPoints& points) {
  std::vector<CriticalPoint> inside;
  std::vector<IrregularBoundaryPoint> boundary;
  for (const FeatureNode& node : state.nodes) {
    if (node.is_inside())
      inside.push_back(inner_point(points, node));
    else if (node.is_changed())
      boundary.push_back({node.curve, node.t, node.position, node.valence, node.changed_by});
    else
      boundary.push_back(points.boundary_nodes[node.source]);
  }
  std::stable_sort(boundary.begin(), boundary.end(),
                   [](const auto& a, const auto& b) { return a.curve != b.curve ? a.curve < b.curve : a.t < b.t; });
  const bool is_changed = std::any_of(state.nodes.begin(), state.nodes.end(), std::mem_fn(&FeatureNode::is_changed)) ||
                          state.nodes.size() < points.critical_points.size() + points.boundary_nodes.size();
  if (is_changed && points.form == "harmonic") points.zeros = points.critical_points;
  if (is_changed) points.form = "phase";
  points.critical_points = std::move(inside);
  points.boundary_nodes = std::move(boundary);
  points.changes.insert(points.changes.end(), state.changes.begin(), state.changes.end());
  points.index_sum = index_sum_of(points);
}

}  // namespace

void resolve_features(const CadFace& face, double size, CriticalPoints& points) {
  if (!(size >= 0) || std::isinf(size)) throw UsageError(fmt::format("the feature size {} is no length", size));
  if (size == 0) return;
  const Walls walls(face);
  FeatureNodes state = nodes_of(face, size, points);
  cancel_pairs(state, walls, size);
  move_to_features(face, walls, state);
  cancel_pairs(state, walls, size / 2);
  separate(state, walls);
  if (!state.changes.empty()) write_back(state, points);
}

}  // namespace quadrille
