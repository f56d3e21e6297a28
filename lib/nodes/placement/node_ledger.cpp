#include "placement/node_ledger.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "base/tolerance.hpp"

namespace quadrille::placement {
namespace {

/// Keeps the zeros of the field before nodes change for the first time.
void keep_zeros(const std::vector<CriticalPoint>& after, CriticalPoints& points) {
  const auto is_same = [](const CriticalPoint& a, const CriticalPoint& b) { return a.position == b.position; };
  const std::vector<CriticalPoint>& before = points.critical_points;
  if (!points.zeros.empty() || std::equal(before.begin(), before.end(), after.begin(), after.end(), is_same)) return;
  std::copy_if(before.begin(), before.end(), std::back_inserter(points.zeros),
               [](const CriticalPoint& p) { return p.source == NodeSource::zero; });
}

std::vector<CriticalPoint> kept_nodes(const std::vector<NodeEdit>& edits, const CriticalPoints& points) {
  std::vector<bool> is_removed(points.critical_points.size(), false);
  for (const NodeEdit& edit : edits)
    for (const std::size_t i : edit.removed) is_removed[i] = true;
  std::vector<CriticalPoint> kept;
  for (std::size_t i = 0; i < is_removed.size(); ++i)
    if (!is_removed[i]) kept.push_back(points.critical_points[i]);
  return kept;
}

void set_valence(const NodeEdit& edit, const CornerValence& to, NodeSet& nodes, NodeChange& change) {
  const auto corner =
      std::find_if(nodes.corners.begin(), nodes.corners.end(), [&](const Corner& c) { return c.joint == to.joint; });
  if (edit.kind != ChangeKind::line) change.before.push_back(mark_of(*corner));
  corner->valence = to.valence;
  corner->source = source_of(edit.kind);
  change.after.push_back(mark_of(*corner));
}

/// Carries out one change in the nodes that are kept; returns its record.
NodeChange change_of(const NodeEdit& edit, const CriticalPoints& points, NodeSet& nodes) {
  NodeChange change{edit.kind, edit.reason, {}, {}};
  for (const CornerValence& to : edit.corners) set_valence(edit, to, nodes, change);
  for (const std::size_t i : edit.removed) change.before.push_back(mark_of(points.critical_points[i]));
  change.before.insert(change.before.end(), edit.zeros.begin(), edit.zeros.end());
  for (const NodeMark& node : edit.added)
    nodes.critical_points.push_back(changed_node({}, node.position, node.valence, source_of(edit.kind)));
  change.after.insert(change.after.end(), edit.added.begin(), edit.added.end());
  return change;
}

}  // namespace

void apply(const std::vector<NodeEdit>& edits, CriticalPoints& points) {
  NodeSet nodes{kept_nodes(edits, points), points.corners, points.boundary_nodes};
  std::vector<NodeChange> changes;
  for (const NodeEdit& edit : edits) changes.push_back(change_of(edit, points, nodes));
  replace_nodes(std::move(nodes), changes, points);
}

void replace_nodes(NodeSet nodes, const std::vector<NodeChange>& changes, CriticalPoints& points) {
  keep_zeros(nodes.critical_points, points);
  if (std::any_of(changes.begin(), changes.end(), [](const NodeChange& c) { return c.kind != ChangeKind::absorb; }))
    points.form = NodeForm::phase;
  points.critical_points = std::move(nodes.critical_points);
  points.corners = std::move(nodes.corners);
  points.boundary_nodes = std::move(nodes.boundary_nodes);
  points.index_sum = index_sum_of(points);
  record(changes, points);
}

void record(const std::vector<NodeChange>& changes, CriticalPoints& points) {
  points.changes.insert(points.changes.end(), changes.begin(), changes.end());
}

CriticalPoint changed_node(CriticalPoint node, Vec2 position, int valence, NodeSource source) {
  node.position = position;
  node.index = 4 - valence;
  node.valence = valence;
  node.jacobian = {};
  node.error = 0;
  node.source = source;
  return node;
}

NodeMark mark_of(const CriticalPoint& node) { return {node.position, node.valence, NodeLocation::inside}; }

NodeMark mark_of(const Corner& corner) { return {corner.position, corner.valence, NodeLocation::corner}; }

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
