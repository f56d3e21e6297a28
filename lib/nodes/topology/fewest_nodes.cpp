#include "topology/fewest_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "curve/symmetry.hpp"
#include "guide/node_ring.hpp"

namespace quadrille::topology {
namespace {

constexpr double equal = 1e-6;  // relative to the diameter

bool are_opposite(const CriticalPoint& a, const CriticalPoint& b) {
  return a.index * b.index < 0 && a.source != NodeSource::divide && b.source != NodeSource::divide;
}

/// Nodes to be merged: the numbers of the nodes, and their centre and total index as a cluster.
struct Group {
  std::vector<int> nodes;
  Cluster cluster;
};

/// The nodes that replace each group. Groups of one symmetry orbit get images of the same nodes.
class Merger {
 public:
  Merger(const CadFace& face, int max_valence, CriticalPoints& points)
      : face_(face), max_valence_(max_valence), points_(points), symmetries_(curve::symmetries(face)) {}

  /// Merges the nearest pairs; false if there are none.
  bool merge_nearest() {
    groups_.clear();
    for (std::vector<int>& set : linked_nodes())
      if (set.size() > 1) groups_.push_back(group_of(std::move(set)));
    if (groups_.empty()) return false;
    merged_.clear();
    for (std::size_t i = 0; i < groups_.size(); ++i) merged_.push_back(nodes_of(i));
    for (std::size_t i = 0; i < groups_.size(); ++i) record(i);
    replace();
    return true;
  }

 private:
  std::vector<std::vector<int>> linked_nodes() const {
    const std::vector<CriticalPoint>& nodes = points_.critical_points;
    double least = INFINITY;
    const auto for_pairs = [&](const auto& visit) {
      for (int i = 0; i < static_cast<int>(nodes.size()); ++i)
        for (int j = 0; j < i; ++j)
          if (are_opposite(nodes[i], nodes[j])) visit(i, j, distance(nodes[i].position, nodes[j].position));
    };
    for_pairs([&](int, int, double length) { least = std::min(least, length); });
    DisjointSets sets(nodes.size());
    for_pairs([&](int i, int j, double length) {
      if (length <= least + equal * face_.diameter) sets.unite(i, j);
    });
    return sets.sets();
  }

  Group group_of(std::vector<int> nodes) const {
    Group group;
    for (const int i : nodes) {
      const CriticalPoint& node = points_.critical_points[i];
      group.cluster.index += node.index;
      group.cluster.centre += node.position / static_cast<double>(nodes.size());
    }
    group.cluster.centre = guide::onto_fixed_points(face_, symmetries_, group.cluster.centre);
    group.nodes = std::move(nodes);
    return group;
  }

  std::vector<Vec2> others(const Group& group) const {
    std::vector<Vec2> positions;
    for (int i = 0; i < static_cast<int>(points_.critical_points.size()); ++i)
      if (!std::binary_search(group.nodes.begin(), group.nodes.end(), i))
        positions.push_back(points_.critical_points[i].position);
    return positions;
  }

  /// The nodes of an earlier group of which this one is an image, moved here.
  std::optional<std::vector<CriticalPoint>> image_of_earlier(std::size_t i) const {
    for (std::size_t j = 0; j < i; ++j)
      for (const curve::Isometry& g : symmetries_) {
        if (groups_[j].cluster.index != groups_[i].cluster.index ||
            distance(g(groups_[j].cluster.centre), groups_[i].cluster.centre) > equal * face_.diameter)
          continue;
        std::vector<CriticalPoint> nodes = merged_[j];
        for (CriticalPoint& node : nodes) node.position = g(node.position);
        return nodes;
      }
    return {};
  }

  std::vector<CriticalPoint> nodes_of(std::size_t i) const {
    const Group& group = groups_[i];
    if (group.cluster.index == 0) return {};
    if (std::optional<std::vector<CriticalPoint>> image = image_of_earlier(i)) return *image;
    return guide::cluster_nodes(face_, symmetries_, max_valence_, group.cluster, others(group), NodeSource::cancel);
  }

  void record(std::size_t i) {
    NodeChange change{ChangeKind::cancel, "", {}, {}};
    for (const int k : groups_[i].nodes) {
      const CriticalPoint& node = points_.critical_points[k];
      change.before.push_back({node.position, node.valence, NodeLocation::inside});
    }
    for (const CriticalPoint& node : merged_[i])
      change.after.push_back({node.position, node.valence, NodeLocation::inside});
    change.reason = fmt::format(
        "as few nodes as possible: {} nodes of opposite index, of total index {}, {}", change.before.size(),
        groups_[i].cluster.index,
        merged_[i].empty() ? std::string("are removed") : fmt::format("become {} of one sign", merged_[i].size()));
    points_.changes.push_back(change);
  }

  void replace() {
    std::vector<bool> is_merged(points_.critical_points.size(), false);
    for (const Group& group : groups_)
      for (const int i : group.nodes) is_merged[i] = true;
    std::vector<CriticalPoint> nodes;
    for (std::size_t i = 0; i < is_merged.size(); ++i)
      if (!is_merged[i]) nodes.push_back(points_.critical_points[i]);
    for (const std::vector<CriticalPoint>& merged : merged_) nodes.insert(nodes.end(), merged.begin(), merged.end());
    points_.critical_points = nodes;
  }

  const CadFace& face_;
  int max_valence_;
  CriticalPoints& points_;
  std::vector<curve::Isometry> symmetries_;
  std::vector<Group> groups_;
  std::vector<std::vector<CriticalPoint>> merged_;  ///< what replaces each group
};

}  // namespace

bool keep_fewest_nodes(const CadFace& face, int max_valence, CriticalPoints& points) {
  const std::vector<CriticalPoint> before = points.critical_points;
  Merger merger(face, max_valence, points);
  bool is_changed = false;
  while (merger.merge_nearest()) is_changed = true;
  if (!is_changed) return false;
  if (points.zeros.empty() && points.form == NodeForm::harmonic) points.zeros = before;
  points.form = NodeForm::phase;
  points.index_sum = index_sum_of(points);
  return true;
}

}  // namespace quadrille::topology
