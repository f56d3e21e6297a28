#pragma once
// Rule "own": the assignment of nodes to small features.

#include "features/feature_state.hpp"
#include "features/small_features.hpp"

namespace quadrille::features {

/// A node of a feature and its foot on the feature's section.
struct OwnedNode {
  int node = 0;
  SectionFoot foot;
};

/// For each feature its nodes, nearest first. An inner node of index 1 (convex bends) or -1 (reflex bends and holes)
/// belongs to the nearest feature of its sign that is nearer than L. It belongs to none
///   - if two features are equally near, unless their nearest points coincide (a hole and a bend of it: then to the
///     bend, which is listed first),
///   - if a run of any size of that sign that is not part of the feature is nearer (curved_runs): that run forced the
///     node.
/// A feature has no more nodes than its index capacity: the nearest, nodes equally near together or not at all.
std::vector<std::vector<OwnedNode>> nodes_of_features(const CadFace& face, const FeatureState& state,
                                                      const std::vector<SmallFeature>& features);

}  // namespace quadrille::features
