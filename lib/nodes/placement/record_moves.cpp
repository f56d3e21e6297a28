#include "placement/record_moves.hpp"

#include <utility>

namespace quadrille::placement {
namespace {

constexpr double moved_tol = 1e-9;  // relative to the diameter: nodes that move less count as not moved

void record_move(CriticalPoint& node, Vec2 to, const std::string& reason, std::vector<NodeChange>& changes) {
  NodeChange change;
  change.kind = ChangeKind::place;
  change.reason = reason;
  change.before = {{node.position, node.valence, NodeLocation::inside}};
  change.after = {{to, node.valence, NodeLocation::inside}};
  changes.push_back(change);
  node.jacobian = {};
  node.error = 0;
  node.source = NodeSource::place;
}

}  // namespace

void record_moves(const CadFace& face, const CriticalPoints& moved, const std::function<std::string(double)>& reason,
                  CriticalPoints& points) {
  CriticalPoints result = points;
  for (std::size_t k = 0; k < points.critical_points.size(); ++k) {
    CriticalPoint& node = result.critical_points[k];
    const Vec2 to = moved.critical_points[k].position;
    const double way = distance(node.position, to);
    if (way > moved_tol * face.diameter) record_move(node, to, reason(way), result.changes);
    node.position = to;
  }
  if (result.changes.size() == points.changes.size()) return;
  if (points.form == NodeForm::harmonic && points.zeros.empty()) result.zeros = points.critical_points;
  result.form = NodeForm::phase;
  points = std::move(result);
}

}  // namespace quadrille::placement
