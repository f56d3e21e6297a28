#include "guide/resolve_clusters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "curve/symmetry.hpp"
#include "guide/node_ring.hpp"

namespace quadrille::guide {
namespace {

constexpr double equal = 1e-6;  // relative to the diameter

bool is_member(const Cluster& cluster, Vec2 x, double tol) {
  return std::any_of(cluster.members.begin(), cluster.members.end(), [&](Vec2 m) { return distance(m, x) <= tol; });
}

/// An earlier, already resolved cluster and the isometry of the face that maps it onto this one.
struct Model {
  std::size_t cluster;
  curve::Isometry map;
};

class Resolver {
 public:
  Resolver(const CadFace& face, int max_valence, CriticalPoints& points)
      : face_(face), max_valence_(max_valence), points_(points), group_(curve::symmetries(face)) {}

  void run() {
    remove_members();
    for (Cluster& cluster : points_.clusters) cluster.centre = onto_fixed_points(face_, group_, cluster.centre);
    align_orbits();
    for (std::size_t i = 0; i < points_.clusters.size(); ++i) nodes_.push_back(nodes_of(i));
    for (std::size_t i = 0; i < points_.clusters.size(); ++i) record(i);
    points_.form = NodeForm::phase;
    points_.index_sum = index_sum_of(points_);
  }

 private:
  void remove_members() {
    const std::vector<CriticalPoint> before = points_.critical_points;
    const double tol = 1e-12 * face_.diameter;
    std::erase_if(points_.critical_points, [&](const CriticalPoint& p) {
      return p.source == NodeSource::zero &&
             std::any_of(points_.clusters.begin(), points_.clusters.end(),
                         [&](const Cluster& c) { return is_member(c, p.position, tol); });
    });
    if (points_.zeros.empty()) points_.zeros = before;
  }

  std::optional<Model> model_of(std::size_t i) const {
    const Cluster& cluster = points_.clusters[i];
    for (std::size_t j = 0; j < i; ++j)
      for (const curve::Isometry& g : group_)
        if (points_.clusters[j].index == cluster.index &&
            distance(g(points_.clusters[j].centre), cluster.centre) < equal * face_.diameter)
          return Model{j, g};
    return {};
  }

  /// Clusters of one orbit get centres that are exact images of each other.
  void align_orbits() {
    for (std::size_t i = 0; i < points_.clusters.size(); ++i) {
      models_.push_back(model_of(i));
      if (models_[i]) points_.clusters[i].centre = models_[i]->map(points_.clusters[models_[i]->cluster].centre);
    }
  }

  std::vector<Vec2> other_positions(std::size_t i) const {
    std::vector<Vec2> positions;
    for (const CriticalPoint& p : points_.critical_points) positions.push_back(p.position);
    for (std::size_t j = 0; j < points_.clusters.size(); ++j)
      if (j != i && points_.clusters[j].index != 0) positions.push_back(points_.clusters[j].centre);
    return positions;
  }

  static ChangeKind kind_of(const Cluster& cluster) {
    return cluster.index == 0 || cluster.is_far_from_boundary ? ChangeKind::cancel : ChangeKind::cluster;
  }

  std::vector<CriticalPoint> nodes_of(std::size_t i) const {
    const Cluster& cluster = points_.clusters[i];
    if (cluster.index == 0) return {};
    if (models_[i]) {
      std::vector<CriticalPoint> nodes = nodes_[models_[i]->cluster];
      for (CriticalPoint& node : nodes) node.position = models_[i]->map(node.position);
      return nodes;
    }
    return cluster_nodes(face_, group_, max_valence_, cluster, other_positions(i), source_of(kind_of(cluster)));
  }

  std::string subject(const Cluster& cluster) const {
    if (cluster.members.size() == 1) return "a multiple zero";
    return fmt::format("{} zeros within {:.3g} of each other, {}", cluster.members.size(), 2 * cluster.radius,
                       cluster.is_undecided ? "whose existence the field does not decide"
                       : cluster.is_far_from_boundary
                           ? "of opposite index and nearer to each other than to the boundary"
                           : "nearer than any block could be");
  }

  std::string reason(const Cluster& cluster, const std::vector<CriticalPoint>& nodes) const {
    const std::string what = subject(cluster);
    if (nodes.empty()) return what + ": they cancel, their indices add up to 0";
    if (nodes.size() == 1)
      return fmt::format("{}, of total index {}: one node of valence {} replaces them", what, cluster.index,
                         nodes[0].valence);
    return fmt::format("{}, of total index {}: {} nodes of valence {} on a circle replace them", what, cluster.index,
                       nodes.size(), nodes[0].valence);
  }

  void record(std::size_t i) {
    const Cluster& cluster = points_.clusters[i];
    NodeChange change{kind_of(cluster), reason(cluster, nodes_[i]), {}, {}};
    if (cluster.member_indices.empty())
      change.before.push_back({cluster.centre, 4 - cluster.index, NodeLocation::inside});
    for (std::size_t k = 0; k < cluster.member_indices.size(); ++k)
      change.before.push_back({cluster.members[k], 4 - cluster.member_indices[k], NodeLocation::inside});
    for (const CriticalPoint& node : nodes_[i]) {
      change.after.push_back({node.position, node.valence, NodeLocation::inside});
      points_.critical_points.push_back(node);
    }
    points_.changes.push_back(change);
  }

  const CadFace& face_;
  int max_valence_;
  CriticalPoints& points_;
  std::vector<curve::Isometry> group_;
  std::vector<std::optional<Model>> models_;
  std::vector<std::vector<CriticalPoint>> nodes_;  ///< of each cluster
};

}  // namespace

void resolve_clusters(const CadFace& face, int max_valence, CriticalPoints& points) {
  if (!points.clusters.empty()) Resolver(face, max_valence, points).run();
}

}  // namespace quadrille::guide
