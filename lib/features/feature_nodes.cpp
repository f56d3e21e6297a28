#include "features/feature_nodes.hpp"

namespace quadrille::features {

void drop_regular(FeatureNodes& state) {
  std::erase_if(state.nodes, [](const FeatureNode& node) { return node.is_inside() && node.valence == 4; });
}

NodeMark mark(const FeatureNode& node) {
  return {node.position, node.valence, node.is_inside() ? NodeLocation::inside : NodeLocation::boundary};
}

void record(FeatureNodes& state, ChangeKind kind, const std::vector<FeatureNode>& before,
            const std::vector<FeatureNode>& after, const std::string& reason) {
  NodeChange change;
  change.kind = kind;
  change.reason = reason;
  for (const FeatureNode& node : before) change.before.push_back(mark(node));
  for (const FeatureNode& node : after) change.after.push_back(mark(node));
  state.changes.push_back(change);
}

}  // namespace quadrille::features
