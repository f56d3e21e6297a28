#include "features/feature_state.hpp"

#include <algorithm>
#include <utility>

namespace quadrille::features {

void remove_nodes(FeatureState& state, const std::vector<int>& removed) {
  std::vector<FeatureNode> kept;
  for (int i = 0; i < static_cast<int>(state.nodes.size()); ++i) {
    if (std::find(removed.begin(), removed.end(), i) == removed.end()) kept.push_back(state.nodes[i]);
  }
  state.nodes = std::move(kept);
}

NodeMark mark(const FeatureNode& node) { return {node.position, node.valence, node.location}; }

void record(FeatureState& state, ChangeKind kind, const std::vector<FeatureNode>& before,
            const std::vector<FeatureNode>& after, const std::string& reason) {
  NodeChange change;
  change.kind = kind;
  change.reason = reason;
  for (const FeatureNode& node : before) change.before.push_back(mark(node));
  for (const FeatureNode& node : after) change.after.push_back(mark(node));
  state.changes.push_back(change);
}

}  // namespace quadrille::features
