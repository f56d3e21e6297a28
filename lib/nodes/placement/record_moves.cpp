#include "placement/record_moves.hpp"

#include <utility>
#include <vector>

#include "base/tolerance.hpp"
#include "placement/node_ledger.hpp"

namespace quadrille::placement {

void record_moves(const CadFace& face, const CriticalPoints& moved, const std::function<std::string(double)>& reason,
                  CriticalPoints& points) {
  NodeSet nodes{points.critical_points, points.corners, points.boundary_nodes};
  std::vector<NodeChange> changes;
  for (std::size_t k = 0; k < nodes.critical_points.size(); ++k) {
    CriticalPoint& node = nodes.critical_points[k];
    const Vec2 from = node.position;
    node.position = moved.critical_points[k].position;
    const double way = distance(from, node.position);
    if (way <= tolerance::round_off * face.diameter) continue;
    node = changed_node(node, node.position, node.valence, NodeSource::place);
    changes.push_back({ChangeKind::place, reason(way), {{from, node.valence}}, {mark_of(node)}});
  }
  if (!changes.empty()) replace_nodes(std::move(nodes), changes, points);
}

}  // namespace quadrille::placement
