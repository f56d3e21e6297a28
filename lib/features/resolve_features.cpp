#include "features/resolve_features.hpp"

// A node of index +-1 belongs to the nearest small feature (features/feature_bends) that carries an index of its sign
// and is nearer than L; one with two features equally near belongs to neither, nor does one that has something larger
// of that kind nearer by. A feature takes no more nodes than it carries, nearest first, nodes equally near together or
// not at all.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "features/feature_bends.hpp"
#include "features/feature_cancel.hpp"
#include "features/feature_inward.hpp"
#include "features/feature_merge.hpp"
#include "features/feature_separate.hpp"

namespace quadrille::features {
namespace {

constexpr double least_block_angle = 15;  // degrees (lib/method.md §5)

struct Claim {
  int node = 0;
  StretchFoot foot;
};

FeatureNodes nodes_of(const CadFace& face, double size, const CriticalPoints& points) {
  FeatureNodes state;
  state.size = size;
  state.tie = 1e-6 * face.diameter;
  state.corners = points.corners;
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

bool share(const Stretch& a, const Stretch& b) {
  for (const CurvePart& p : a.parts()) {
    for (const CurvePart& q : b.parts()) {
      if (p.curve == q.curve && p.t0 < q.t1 && q.t0 < p.t1) return true;
    }
  }
  return false;
}

/// Whether a run that is no part of the feature is nearer to the node.
bool has_nearer(const FeatureNodes& state, const std::vector<SmallFeature>& runs, const SmallFeature& feature,
                const FeatureNode& node, double distance) {
  return std::any_of(runs.begin(), runs.end(), [&](const SmallFeature& run) {
    return (run.kind == FeatureKind::convex) == (feature.kind == FeatureKind::convex) &&
           !share(run.stretch, feature.stretch) && run.stretch.foot(node.position).distance < distance - state.tie;
  });
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

std::vector<std::vector<Claim>> claims_of(const CadFace& face, const FeatureNodes& state,
                                          const std::vector<SmallFeature>& features) {
  const std::vector<SmallFeature> runs = runs_of_any_size(face);
  std::vector<std::vector<Claim>> claims(features.size());
  for (size_t i = 0; i < state.nodes.size(); ++i) {
    const FeatureNode& node = state.nodes[i];
    StretchFoot foot;
    if (!node.is_inside() || std::abs(node.index()) != 1) continue;
    const int f = owner(state, features, node, foot);
    if (f >= 0 && !has_nearer(state, runs, features[f], node, foot.distance))
      claims[f].push_back({static_cast<int>(i), foot});
  }
  for (size_t f = 0; f < features.size(); ++f) keep_carried(state, features[f].capacity, claims[f]);
  return claims;
}

/// `n` places, evenly over an open stretch, or over a closed one with the mean offset of the `wanted` (ascending).
std::vector<BoundaryPlace> even_places(const Stretch& stretch, const std::vector<double>& wanted) {
  const double n = static_cast<double>(wanted.size());
  double offset = stretch.is_closed() ? 0 : 0.5 / n;
  for (size_t i = 0; stretch.is_closed() && i < wanted.size(); ++i)
    offset += (wanted[i] - static_cast<double>(i) / n) / n;
  std::vector<BoundaryPlace> even;
  for (size_t i = 0; i < wanted.size(); ++i) even.push_back(stretch.at(offset + static_cast<double>(i) / n));
  return even;
}

/// The least distance between two that follow each other.
double least_distance(const std::vector<BoundaryPlace>& places, bool is_closed) {
  double least = std::numeric_limits<double>::infinity();
  for (size_t i = is_closed ? 0 : 1; places.size() > 1 && i < places.size(); ++i)
    least = std::min(least, distance(places[i].position, places[i == 0 ? places.size() - 1 : i - 1].position));
  return least;
}

/// Where nodes go, in ascending sequence of the fractions of their feet: to the middle of a feature made for one, else
/// to the feet on the run. Evenly where the feet are nearer than half a radius, or on a hole nearer than half as far as
/// evenly, or nearer than `apart` where evenly they are not.
std::vector<BoundaryPlace> places_on(const SmallFeature& feature, const std::vector<double>& feet, double apart) {
  const bool is_hole = feature.kind == FeatureKind::hole;
  if (!is_hole && feature.capacity == 1) return {feature.stretch.at(0.5)};
  std::vector<BoundaryPlace> places;
  for (const double foot : feet) places.push_back(feature.run.at(foot));
  const std::vector<BoundaryPlace> even = even_places(feature.stretch, feet);
  const double here = least_distance(places, is_hole), there = least_distance(even, is_hole);
  const bool is_crowded =
      here < (is_hole ? 0.5 * there : 0.5 * feature.extent) || (is_hole && here < apart && there >= apart);
  return is_crowded ? even : places;
}

std::string reason(const FeatureNodes& state, const SmallFeature& feature, double distance) {
  const std::string what = feature.kind == FeatureKind::hole
                               ? fmt::format("a hole of diameter {:.4g}", feature.extent)
                               : fmt::format("a reflex fillet of radius {:.4g}", feature.extent);
  return fmt::format("{} is below the feature size {:.4g}: a node of valence 5 goes onto it, from {:.4g} away", what,
                     state.size, distance);
}

/// A corner of valence V takes a node of valence 5 for V + 1 blocks; not where they were more than four or too narrow.
void put_into_corner(FeatureNodes& state, int joint, int k, const std::string& why) {
  const auto corner =
      std::find_if(state.corners.begin(), state.corners.end(), [&](const Corner& c) { return c.joint == joint; });
  if (corner == state.corners.end() || corner->valence >= 4 ||
      corner->angle_degrees < least_block_angle * (corner->valence + 1))
    return;
  const NodeMark before{corner->position, corner->valence, NodeLocation::corner};
  corner->valence += 1;
  corner->source = NodeSource::feature;
  const NodeMark after{corner->position, corner->valence, NodeLocation::corner};
  state.changes.push_back({ChangeKind::feature, why, {mark(state.nodes[k]), before}, {after}});
  state.nodes[k].valence = 4;
}

void put_onto(const CadFace& face, FeatureNodes& state, const SmallFeature& feature, int id,
              std::vector<Claim> claims) {
  for (Claim& claim : claims) claim.foot = feature.run.foot(state.nodes[claim.node].position);
  std::stable_sort(claims.begin(), claims.end(),
                   [](const Claim& a, const Claim& b) { return a.foot.fraction < b.foot.fraction; });
  std::vector<double> feet;
  for (const Claim& claim : claims) feet.push_back(claim.foot.fraction);
  const int hole = feature.kind == FeatureKind::hole ? id : -1;
  const std::vector<BoundaryPlace> places = places_on(feature, feet, state.size / 2);
  for (size_t i = 0; i < claims.size(); ++i) {
    const BoundaryPlace& place = places[i];
    FeatureNode& node = state.nodes[claims[i].node];
    const std::string why = reason(state, feature, claims[i].foot.distance);
    if (face.joints[place.curve].is_corner && place.t == face.curves[place.curve].begin()) {
      put_into_corner(state, place.curve, claims[i].node, why);
      continue;
    }
    const FeatureNode before = node;
    node = {place.position, 3, place.curve, place.t, before.source, hole, ChangeKind::feature};
    record(state, ChangeKind::feature, {before}, {node}, why);
  }
}

/// Along the bend's bisector where it is made for one node, else away from the node's own foot.
InwardMove inward_move(const CadFace& face, const FeatureNode& node, const SmallFeature& feature, const Claim& claim) {
  if (feature.capacity > 1)
    return {claim.node, node.position, normalized(node.position - claim.foot.position), feature.extent};
  const BoundaryPlace middle = feature.stretch.at(0.5);
  const Vec2 inward = left_of(curve::tangent(face.curves[middle.curve], middle.t));
  return {claim.node, middle.position + dot(node.position - middle.position, inward) * inward, inward, feature.extent};
}

void move_to_features(const CadFace& face, const Walls& walls, FeatureNodes& state) {
  const std::vector<SmallFeature> features = small_features(face, state.size);
  const std::vector<std::vector<Claim>> claims = claims_of(face, state, features);
  std::vector<InwardMove> moves;
  for (size_t f = 0; f < features.size(); ++f) {
    if (claims[f].empty()) continue;
    if (features[f].kind != FeatureKind::convex) {
      put_onto(face, state, features[f], static_cast<int>(f), claims[f]);
      continue;
    }
    for (const Claim& claim : claims[f])
      moves.push_back(inward_move(face, state.nodes[claim.node], features[f], claim));
  }
  move_inward(state, walls, moves);
  drop_regular(state);
}

CriticalPoint inner_point(const CriticalPoints& points, const FeatureNode& node) {
  CriticalPoint point = points.critical_points[node.source];
  if (!node.is_changed()) return point;
  point.position = node.position;
  point.valence = node.valence;
  point.index = 4 - node.valence;
  point.jacobian = {};
  point.error = 0;
  point.source = source_of(*node.changed_by);
  return point;
}

void write_back(const FeatureNodes& state, CriticalPoints& points) {
  std::vector<CriticalPoint> inside;
  std::vector<IrregularBoundaryPoint> boundary;
  for (const FeatureNode& node : state.nodes) {
    if (node.is_inside())
      inside.push_back(inner_point(points, node));
    else if (node.is_changed())
      boundary.push_back({node.curve, node.t, node.position, node.valence, source_of(*node.changed_by)});
    else
      boundary.push_back(points.boundary_nodes[node.source]);
  }
  std::stable_sort(boundary.begin(), boundary.end(),
                   [](const auto& a, const auto& b) { return a.curve != b.curve ? a.curve < b.curve : a.t < b.t; });
  const bool is_changed = std::any_of(state.nodes.begin(), state.nodes.end(), std::mem_fn(&FeatureNode::is_changed)) ||
                          state.nodes.size() < points.critical_points.size() + points.boundary_nodes.size();
  if (is_changed && points.form == NodeForm::harmonic) points.zeros = points.critical_points;
  if (is_changed) points.form = NodeForm::phase;
  points.critical_points = std::move(inside);
  points.boundary_nodes = std::move(boundary);
  points.corners = state.corners;
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
  merge_on_boundary(face, state);
  separate(state, walls);
  if (!state.changes.empty()) write_back(state, points);
}

}  // namespace quadrille::features
