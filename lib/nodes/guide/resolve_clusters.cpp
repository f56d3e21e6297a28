#include "guide/resolve_clusters.hpp"

#include <fmt/format.h>

#include "curve/symmetry.hpp"
#include "guide/node_ring.hpp"
#include "placement/node_ledger.hpp"

namespace quadrille::guide {
namespace {

std::vector<Vec2> other_positions(const CriticalPoints& points, std::size_t cluster) {
  std::vector<Vec2> positions;
  for (const CriticalPoint& p : points.critical_points) positions.push_back(p.position);
  for (std::size_t j = 0; j < points.clusters.size(); ++j)
    if (j != cluster && points.clusters[j].index != 0) positions.push_back(points.clusters[j].centre);
  return positions;
}

std::string subject(const Cluster& cluster) {
  if (cluster.members.size() == 1) return "a multiple zero";
  return fmt::format("{} zeros within {:.3g} of each other, {}", cluster.members.size(), 2 * cluster.radius,
                     cluster.is_undecided           ? "whose existence the field does not decide"
                     : cluster.is_far_from_boundary ? "of opposite index and nearer to each other than to the boundary"
                                                    : "nearer than any block could be");
}

std::string reason(const Cluster& cluster, const std::vector<NodeMark>& nodes) {
  const std::string what = subject(cluster);
  if (nodes.empty()) return what + ": they cancel, their indices add up to 0";
  if (nodes.size() == 1)
    return fmt::format("{}, of total index {}: one node of valence {} replaces them", what, cluster.index,
                       nodes[0].valence);
  return fmt::format("{}, of total index {}: {} nodes of valence {} on a circle replace them", what, cluster.index,
                     nodes.size(), nodes[0].valence);
}

std::vector<NodeMark> members(const Cluster& cluster) {
  if (cluster.member_indices.empty()) return {{cluster.centre, 4 - cluster.index}};
  std::vector<NodeMark> marks;
  for (std::size_t k = 0; k < cluster.member_indices.size(); ++k)
    marks.push_back({cluster.members[k], 4 - cluster.member_indices[k]});
  return marks;
}

}  // namespace

void resolve_clusters(const CadFace& face, int max_valence, CriticalPoints& points) {
  if (points.clusters.empty()) return;
  const auto others = [&](std::size_t i) { return other_positions(points, i); };
  const std::vector<std::vector<NodeMark>> nodes =
      nodes_of_clusters(face, curve::symmetries(face), max_valence, points.clusters, others);
  std::vector<placement::NodeEdit> edits;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Cluster& cluster = points.clusters[i];
    const bool is_cancelled = cluster.index == 0 || cluster.is_far_from_boundary;
    edits.push_back({is_cancelled ? ChangeKind::cancel : ChangeKind::cluster,
                     reason(cluster, nodes[i]),
                     {},
                     nodes[i],
                     {},
                     members(cluster)});
  }
  placement::apply(edits, points);
}

}  // namespace quadrille::guide
