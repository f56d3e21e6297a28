#include "features/feature_owners.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace quadrille::features {
namespace {

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

}  // namespace

std::vector<std::vector<OwnedNode>> nodes_of_features(const CadFace& face, const FeatureState& state,
                                                      const std::vector<SmallFeature>& features) {
  const std::vector<SmallFeature> runs = runs_of_any_size(face);
  std::vector<std::vector<OwnedNode>> owned(features.size());
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

}  // namespace quadrille::features
