#include "topology/fewest_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "base/tolerance.hpp"
#include "curve/symmetry.hpp"
#include "guide/node_ring.hpp"
#include "placement/node_ledger.hpp"

namespace quadrille::topology {
namespace {

bool are_opposite(const CriticalPoint& a, const CriticalPoint& b) {
  return a.index * b.index < 0 && a.source != NodeSource::divide && b.source != NodeSource::divide;
}

/// Sets of nodes that pairs of opposite index, nearest to each other of all, link; ascending.
std::vector<std::vector<std::size_t>> nearest_opposite(const CadFace& face, const std::vector<CriticalPoint>& nodes) {
  double least = INFINITY;
  const auto for_pairs = [&](const auto& visit) {
    for (int i = 0; i < static_cast<int>(nodes.size()); ++i)
      for (int j = 0; j < i; ++j)
        if (are_opposite(nodes[i], nodes[j])) visit(i, j, distance(nodes[i].position, nodes[j].position));
  };
  for_pairs([&](int, int, double length) { least = std::min(least, length); });
  DisjointSets linked(nodes.size());
  for_pairs([&](int i, int j, double length) {
    if (length <= least + tolerance::tied * face.diameter) linked.unite(i, j);
  });
  std::vector<std::vector<std::size_t>> sets;
  for (const std::vector<int>& set : linked.sets())
    if (set.size() > 1) sets.emplace_back(set.begin(), set.end());
  return sets;
}

Cluster cluster_of(const std::vector<CriticalPoint>& nodes, const std::vector<std::size_t>& set) {
  Cluster cluster;
  for (const std::size_t i : set) {
    cluster.index += nodes[i].index;
    cluster.centre += nodes[i].position / static_cast<double>(set.size());
  }
  return cluster;
}

std::vector<Vec2> other_positions(const std::vector<CriticalPoint>& nodes, const std::vector<std::size_t>& set) {
  std::vector<Vec2> positions;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (!std::binary_search(set.begin(), set.end(), i)) positions.push_back(nodes[i].position);
  return positions;
}

/// Merges the nodes of each set.
void merge(const CadFace& face, const std::vector<curve::Isometry>& symmetries, int max_valence,
           const std::vector<std::vector<std::size_t>>& sets, CriticalPoints& points) {
  std::vector<Cluster> clusters;
  for (const std::vector<std::size_t>& set : sets) clusters.push_back(cluster_of(points.critical_points, set));
  const auto others = [&](std::size_t i) { return other_positions(points.critical_points, sets[i]); };
  const std::vector<std::vector<NodeMark>> merged =
      guide::nodes_of_clusters(face, symmetries, max_valence, clusters, others);
  std::vector<placement::NodeEdit> edits;
  for (std::size_t i = 0; i < sets.size(); ++i)
    edits.push_back({ChangeKind::cancel,
                     fmt::format("as few nodes as possible: {} nodes of opposite index, of total index {}, {}",
                                 sets[i].size(), clusters[i].index,
                                 merged[i].empty() ? std::string("are removed")
                                                   : fmt::format("become {} of one sign", merged[i].size())),
                     {},
                     merged[i],
                     sets[i]});
  placement::apply(edits, points);
}

}  // namespace

bool keep_fewest_nodes(const CadFace& face, int max_valence, CriticalPoints& points) {
  const std::vector<curve::Isometry> symmetries = curve::symmetries(face);
  bool is_changed = false;
  for (;;) {
    const std::vector<std::vector<std::size_t>> sets = nearest_opposite(face, points.critical_points);
    if (sets.empty()) return is_changed;
    merge(face, symmetries, max_valence, sets, points);
    is_changed = true;
  }
}

}  // namespace quadrille::topology
