#include "features/small_features.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/number_list.hpp"
#include "base/tolerance.hpp"
#include "curve/face_boundary.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "features/feature_state.hpp"
#include "model/name_rules.hpp"

namespace quadrille::features {
namespace {

/// The run that contains the bend: the one around the middle of the bend's first interval.
const CurvedRun& run_around(const std::vector<CurvedRun>& runs, const CurvedRun& bend) {
  const CurveInterval& first = bend.parts.front().interval;
  const double middle = (first.t0 + first.t1) / 2;
  for (const CurvedRun& run : runs) {
    for (const CurvedInterval& part : run.parts) {
      if (part.interval.curve == first.curve && part.interval.t0 <= middle && middle <= part.interval.t1) return run;
    }
  }
  return bend;
}

FeatureKind kind_of(const CurvedRun& run) {
  return run.side() == TurnSide::left ? FeatureKind::convex : FeatureKind::reflex;
}

std::vector<CurvedRun> all_runs(const CadFace& face, int loop) {
  return curved_runs(face, loop, feature_constants.straight_curvature / face.diameter);
}

/// The largest distance between two sample points of a loop, or any distance above `enough` as soon as it is found.
double diameter_of(const CadFace& face, int loop, double enough) {
  std::vector<Vec2> points;
  for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c) {
    for (const double t : sample_parameters(face.curves[c])) points.push_back(curve::point(face.curves[c], t));
  }
  double largest = 0;
  for (const Vec2 a : points) {
    for (const Vec2 b : points) largest = std::max(largest, distance(a, b));
    if (largest > enough) break;
  }
  return largest;
}

int hole_capacity(const CadFace& face, int loop) {
  int sum = 4;
  for (int j = face.loop_offsets[loop]; j < face.loop_offsets[loop + 1]; ++j) {
    const Joint& joint = face.joints[j];
    if (joint.is_corner) sum += 2 - static_cast<int>(std::lround(joint.interior_angle / half_pi));
  }
  return std::max(sum, 0);
}

/// Adds the bends of a loop below `size`; the bends of a hole that is one small run all round are part of the hole.
void add_bends(const CadFace& face, int loop, double size, bool is_small_hole, std::vector<SmallFeature>& bends) {
  const std::vector<CurvedRun> found = curved_runs(face, loop, 1 / size);
  if (found.empty()) return;
  const std::vector<CurvedRun> runs = all_runs(face, loop);
  for (const CurvedRun& bend : found) {
    const CurvedRun& run = run_around(runs, bend);
    const int capacity = index_capacity_of(run.turning());
    if (bend.is_loop || (is_small_hole && run.is_loop) || capacity == 0) continue;
    bends.push_back({kind_of(bend), LoopSection(face, bend.intervals(), false),
                     LoopSection(face, run.intervals(), run.is_loop), bend.least_radius(), capacity});
  }
}

bool has_sign(const SmallFeature& feature, const FeatureNode& node) {
  return (feature.kind == FeatureKind::convex) == (node.index() > 0);
}

struct Owner {
  int feature = 0;
  SectionFoot foot;
};

std::optional<Owner> owning_feature(const FeatureState& state, const std::vector<SmallFeature>& features,
                                    const FeatureNode& node) {
  std::optional<Owner> nearest;
  bool is_tied = false;
  for (size_t f = 0; f < features.size(); ++f) {
    if (!has_sign(features[f], node)) continue;
    const SectionFoot here = features[f].section.foot(node.position);
    if (here.distance >= state.size - state.tie) continue;
    if (nearest && here.distance > nearest->foot.distance - state.tie) {
      is_tied |= here.distance < nearest->foot.distance + state.tie &&
                 distance(here.position, nearest->foot.position) > state.tie;
      continue;
    }
    nearest = Owner{static_cast<int>(f), here};
    is_tied = false;
  }
  return is_tied ? std::nullopt : nearest;
}

/// Whether a run that is not part of the feature is nearer to the node.
bool has_nearer_run(const FeatureState& state, const std::vector<SmallFeature>& runs, const SmallFeature& feature,
                    const FeatureNode& node, double distance) {
  return std::any_of(runs.begin(), runs.end(), [&](const SmallFeature& run) {
    return (run.kind == FeatureKind::convex) == (feature.kind == FeatureKind::convex) &&
           !do_overlap(run.section, feature.section) && run.section.foot(node.position).distance < distance - state.tie;
  });
}

/// Keeps at most as many nodes as the feature's capacity; nodes of equal distance together or not at all.
void keep_to_capacity(const FeatureState& state, size_t capacity, std::vector<OwnedNode>& owned) {
  std::stable_sort(owned.begin(), owned.end(),
                   [](const OwnedNode& a, const OwnedNode& b) { return a.foot.distance < b.foot.distance; });
  if (owned.size() <= capacity) return;
  size_t kept = capacity;
  while (kept > 0 && owned[kept].foot.distance - owned[kept - 1].foot.distance <= state.tie) --kept;
  owned.resize(kept);
}

/// The diameter of the face; in a far field, that of the box around the bodies, which a far field may exceed at will.
/// Around layers with blocks of their own it is that of the face: the curves above layers are smooth, and between two
/// of them fewer nodes are better (two elements of an aerofoil in a box: 56 blocks in place of 64).
double reference_length(const CadFace& face) {
  if (!has_far_field(face)) return face.diameter;
  std::vector<Nurbs> bodies;
  for (int curve = 0; curve < face.num_curves(); ++curve) {
    if (is_offset_name(face.curve_names[curve])) return face.diameter;
    if (!is_far_field(face, curve) && !face.is_interface(curve)) bodies.push_back(face.curves[curve]);
  }
  return bodies.empty() ? face.diameter : std::min(face.diameter, curve::pole_box(bodies).diagonal());
}

}  // namespace

int index_capacity_of(double turning) {
  return static_cast<int>(std::floor(turning / half_pi + feature_constants.index_rounding));
}

std::vector<SmallFeature> small_features(const CadFace& face, double size) {
  const double below = size * (1 - tolerance::tied);
  std::vector<SmallFeature> features, holes;
  for (int loop = 0; loop < face.num_loops(); ++loop) {
    const double extent = loop == 0 ? face.diameter : diameter_of(face, loop, below);
    const bool is_small_hole = loop > 0 && extent < below;
    add_bends(face, loop, below, is_small_hole, features);
    if (!is_small_hole) continue;
    const LoopSection whole = whole_loop(face, loop);
    holes.push_back({FeatureKind::hole, whole, whole, extent, hole_capacity(face, loop)});
  }
  features.insert(features.end(), holes.begin(), holes.end());
  return features;
}

std::vector<SmallFeature> runs_of_any_size(const CadFace& face) {
  std::vector<SmallFeature> features;
  for (int loop = 0; loop < face.num_loops(); ++loop) {
    for (const CurvedRun& run : all_runs(face, loop)) {
      const int capacity = index_capacity_of(run.turning());
      if (capacity == 0 || (loop == 0 && run.is_loop)) continue;
      const LoopSection section(face, run.intervals(), run.is_loop);
      features.push_back(
          {run.is_loop ? FeatureKind::hole : kind_of(run), section, section, run.least_radius(), capacity});
    }
  }
  return features;
}

std::vector<std::vector<OwnedNode>> nodes_of_features(const CadFace& face, const FeatureState& state,
                                                      const std::vector<SmallFeature>& features) {
  std::vector<std::vector<OwnedNode>> owned(features.size());
  if (features.empty()) return owned;
  const std::vector<SmallFeature> runs = runs_of_any_size(face);
  for (size_t i = 0; i < state.nodes.size(); ++i) {
    const FeatureNode& node = state.nodes[i];
    if (!node.is_inside() || std::abs(node.index()) != 1) continue;
    const std::optional<Owner> owner = owning_feature(state, features, node);
    if (owner && !has_nearer_run(state, runs, features[owner->feature], node, owner->foot.distance))
      owned[owner->feature].push_back({static_cast<int>(i), owner->foot});
  }
  for (size_t f = 0; f < features.size(); ++f)
    keep_to_capacity(state, static_cast<size_t>(features[f].index_capacity), owned[f]);
  return owned;
}

double automatic_feature_size(const CadFace& face) {
  return std::min(feature_constants.automatic_size * reference_length(face), curve::mean_width(face) / 2);
}

std::optional<double> parse_feature_size(const std::string& text) {
  if (text == "auto") return std::nullopt;
  const std::optional<double> size = finite_number_of(text);
  if (!size || *size < 0)
    throw UsageError(fmt::format("--feature-size {}: expected \"auto\" or a length in file units, 0 or above", text));
  return size;
}

}  // namespace quadrille::features
