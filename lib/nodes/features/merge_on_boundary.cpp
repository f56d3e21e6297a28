#include "features/merge_on_boundary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "base/tolerance.hpp"
#include "features/acts_as_corner.hpp"
#include "features/feature_constants.hpp"
#include "features/loop_section.hpp"
#include "features/nearest_first.hpp"

namespace quadrille::features {
namespace {

struct BoundaryPair {
  double distance = 0;
  int a = 0, b = 0;
  SectionPoint middle;
};

using Pairs = std::vector<BoundaryPair>;

/// A part of a whole loop, as fractions of its length: it starts at `first` and is `part` long.
struct LoopPart {
  double first = 0, part = 0;
};

bool has_corner(const CadFace& face, int loop, const LoopSection& whole, const LoopPart& between) {
  for (int j = face.loop_offsets[loop]; j < face.loop_offsets[loop + 1]; ++j) {
    if (!face.joints[j].is_corner) continue;
    const double at = whole.foot(face.joints[j].position).fraction - between.first;
    if (at - std::floor(at) <= between.part) return true;
  }
  return false;
}

/// The shorter part of the loop between the two points.
LoopPart shorter_part(const LoopSection& whole, Vec2 a, Vec2 b) {
  double first = whole.foot(a).fraction, part = whole.foot(b).fraction - first;
  part -= std::floor(part);
  if (part > 0.5) {
    first += part;
    part = 1 - part;
  }
  return {first, part};
}

std::optional<SectionPoint> middle_between(const CadFace& face, const FeatureNode& a, const FeatureNode& b) {
  const int loop = face.loop_of(a.curve);
  if (loop != face.loop_of(b.curve)) return {};
  const LoopSection whole = whole_loop(face, loop);
  const LoopPart between = shorter_part(whole, a.position, b.position);
  const double greatest = feature_constants.greatest_merge_detour * distance(a.position, b.position);
  if (between.part * whole.length() > greatest || has_corner(face, loop, whole, between)) return {};
  return whole.at(between.first + between.part / 2);
}

bool may_merge(const FeatureNode& a, const FeatureNode& b) {
  if (a.is_inside() || b.is_inside() || a.valence != 3 || b.valence != 3) return false;
  return !a.hole || a.hole != b.hole;
}

Pairs close_pairs(const CadFace& face, const FeatureState& state) {
  const auto pair_of = [&](int i, int j) -> std::optional<BoundaryPair> {
    const FeatureNode &a = state.nodes[i], &b = state.nodes[j];
    const double d = distance(a.position, b.position);
    if (!may_merge(a, b) || d >= feature_constants.spacing * state.size - state.tie) return std::nullopt;
    if (is_on_corner_fillet(face, a, d) || is_on_corner_fillet(face, b, d)) return std::nullopt;
    const auto middle = middle_between(face, a, b);
    return middle ? std::optional(BoundaryPair{d, i, j, *middle}) : std::nullopt;
  };
  return nearest_first<BoundaryPair>(static_cast<int>(state.nodes.size()), pair_of);
}

/// Replaces the first node of the pair by the merged one.
void merge(FeatureState& state, const BoundaryPair& pair) {
  const FeatureNode a = state.nodes[pair.a], b = state.nodes[pair.b];
  FeatureNode merged = a;
  merged.position = pair.middle.position;
  merged.curve = pair.middle.curve;
  merged.t = pair.middle.t;
  merged.valence = 4;
  merged.changed_by = ChangeKind::feature;
  record(
      state, ChangeKind::feature, {a, b}, {merged},
      fmt::format("two boundary nodes are {:.4g} apart, less than half the feature size, {:.4g}: one node of valence "
                  "4 replaces them",
                  pair.distance, feature_constants.spacing * state.size));
  state.nodes[pair.a] = merged;
}

/// Merges the pairs of a class that have no node in common with others of it. Returns the second node of each, to be
/// removed.
std::vector<int> merge_class(FeatureState& state, Pairs::const_iterator first, Pairs::const_iterator last) {
  std::vector<int> uses(state.nodes.size()), removed;
  for (auto pair = first; pair != last; ++pair) ++uses[pair->a], ++uses[pair->b];
  for (; first != last; ++first) {
    if (uses[first->a] > 1 || uses[first->b] > 1) continue;
    merge(state, *first);
    removed.push_back(first->b);
  }
  return removed;
}

/// Merges the nearest class that has pairs to merge; false if no class has any.
bool merge_nearest(const CadFace& face, FeatureState& state) {
  const Pairs pairs = close_pairs(face, state);
  const auto distance_of = [](const BoundaryPair& pair) { return pair.distance; };
  for (auto first = pairs.begin(); first != pairs.end();) {
    const auto last = end_of_chained_ties(first, pairs.end(), state.tie, distance_of);
    const std::vector<int> removed = merge_class(state, first, last);
    remove_nodes(state, removed);
    if (!removed.empty()) return true;
    first = last;
  }
  return false;
}

}  // namespace

void merge_on_boundary(const CadFace& face, FeatureState& state) {
  while (merge_nearest(face, state)) {
  }
}

}  // namespace quadrille::features
