#include "guide/resolve_clusters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <optional>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "curve/face_boundary.hpp"
#include "curve/symmetry.hpp"
#include "placement/node_ledger.hpp"

namespace quadrille::guide {
namespace {

std::vector<Vec2> regular_polygon(Vec2 centre, double radius, double angle, int n) {
  std::vector<Vec2> vertices;
  for (int k = 0; k < n; ++k) vertices.push_back(centre + radius * unit(angle + 2 * pi * k / n));
  return vertices;
}

std::vector<double> axis_directions(const CadFace& face, const std::vector<curve::Isometry>& group, Vec2 centre) {
  std::vector<double> directions;
  for (const curve::Isometry& g : group) {
    if (!g.is_mirrored || distance(g(centre), centre) > tolerance::same_point * face.diameter) continue;
    directions.push_back(g.angle / 2);
    directions.push_back(g.angle / 2 + pi);
  }
  return directions;
}

std::vector<double> foot_directions(const curve::FaceBoundary& boundary, Vec2 centre) {
  std::vector<double> directions;
  for (const curve::NearestPoint& foot : boundary.nearest_feet(centre, tolerance::tied * boundary.face().diameter))
    directions.push_back(angle_of(foot.position - centre));
  return directions;
}

/// Orientations with a vertex or the middle of a side in each direction.
std::vector<double> with_sides(const std::vector<double>& directions, int n) {
  std::vector<double> angles;
  for (const double d : directions)
    for (const double angle : {d, d + pi / n}) angles.push_back(angle);
  return angles;
}

/// The orientation of the members' own positions; std::nullopt if these do not exceed the noise.
std::optional<double> member_angle(const curve::FaceBoundary& boundary, const Cluster& cluster) {
  const int n = std::abs(cluster.index);
  const int sign = cluster.index > 0 ? 1 : -1;
  if (static_cast<int>(cluster.members.size()) != n || static_cast<int>(cluster.member_indices.size()) != n) return {};
  const double noise = std::pow(1e-8, 1.0 / n) * boundary.nearest(cluster.centre).distance;
  Vec2 sum;
  for (int i = 0; i < n; ++i) {
    const Vec2 from_centre = cluster.members[i] - cluster.centre;
    if (cluster.member_indices[i] != sign || norm(from_centre) < noise) return {};
    sum += unit(n * angle_of(from_centre));
  }
  if (norm(sum) < 0.5 * n) return {};
  return angle_of(sum) / n;
}

/// Keeps the angles whose measure is within `tol` of the least.
void keep_least(std::vector<double>& angles, double tol, const std::function<double(double)>& measure) {
  std::vector<double> values;
  for (const double a : angles) values.push_back(measure(a));
  const double least = *std::min_element(values.begin(), values.end());
  std::vector<double> kept;
  for (std::size_t i = 0; i < angles.size(); ++i)
    if (values[i] <= least + tol) kept.push_back(angles[i]);
  angles = kept;
}

double orientation(const curve::FaceBoundary& boundary, const std::vector<curve::Isometry>& group,
                   const Cluster& cluster) {
  const CadFace& face = boundary.face();
  const int n = std::abs(cluster.index);
  const double period = 2 * pi / n;
  const std::optional<double> members = member_angle(boundary, cluster);
  std::vector<double> directions = axis_directions(face, group, cluster.centre);
  if (directions.empty() && members) return *members;
  if (directions.empty()) directions = foot_directions(boundary, cluster.centre);
  std::vector<double> angles = with_sides(directions, n);
  if (members)
    keep_least(angles, tolerance::same_angle, [&](double a) { return std::abs(std::remainder(a - *members, period)); });
  keep_least(angles, tolerance::tied * face.diameter, [&](double a) {
    double clearance = 0;
    for (int k = 0; k < n; ++k) clearance += boundary.length_inside(cluster.centre, unit(a + k * period)) / n;
    return cluster.index > 0 ? -clearance : clearance;
  });
  const double joint = angle_of(face.joints[0].position - cluster.centre);
  const auto beside_joint = [&](double a) { return std::remainder(a - joint, period); };
  keep_least(angles, tolerance::same_angle, [&](double a) { return std::abs(beside_joint(a)); });
  keep_least(angles, tolerance::same_angle, [&](double a) { return -beside_joint(a); });
  return angles.front();
}

double radius_inside(const Cluster& cluster, double clearance, const std::vector<Vec2>& others) {
  double radius = 0.5 * clearance;
  for (const Vec2 x : others) radius = std::min(radius, distance(x, cluster.centre) / 3);
  return radius;
}

/// For a cluster about a hole: the radius at which the polygon's vertices have the greatest clearance.
double radius_outside(const curve::FaceBoundary& boundary, const Cluster& cluster, double angle) {
  constexpr int steps = 200;
  const double diameter = boundary.face().diameter;
  double best = 0, most = -INFINITY;
  for (int i = 1; i < steps; ++i) {
    double clearance = INFINITY;
    for (const Vec2 x : regular_polygon(cluster.centre, diameter * i / steps, angle, std::abs(cluster.index)))
      clearance = std::min(clearance, boundary.signed_distance(x));
    if (clearance > most + tolerance::tied * diameter) most = clearance, best = diameter * i / steps;
  }
  return best;
}

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

Vec2 onto_fixed_points(const CadFace& face, const std::vector<curve::Isometry>& group, Vec2 x) {
  const double reach = tolerance::same_point * face.diameter;
  if (group.size() > 1 && !group[1].is_mirrored && distance(x, group[1].centre) < reach) return group[1].centre;
  for (const curve::Isometry& g : group)
    if (g.is_mirrored && distance(g(x), x) < 2 * reach) return (x + g(x)) / 2;
  return x;
}

std::vector<Vec2> node_ring(const CadFace& face, const std::vector<curve::Isometry>& group, const Cluster& cluster,
                            const std::vector<Vec2>& others) {
  const curve::FaceBoundary boundary(face);
  const double clearance = boundary.signed_distance(cluster.centre);
  if (std::abs(cluster.index) == 1 && clearance > 0) return {cluster.centre};
  const double angle = orientation(boundary, group, cluster);
  const double radius =
      clearance > 0 ? radius_inside(cluster, clearance, others) : radius_outside(boundary, cluster, angle);
  return regular_polygon(cluster.centre, radius, angle, std::abs(cluster.index));
}

std::vector<NodeMark> cluster_nodes(const CadFace& face, const std::vector<curve::Isometry>& group, int max_valence,
                                    const Cluster& cluster, const std::vector<Vec2>& others) {
  const int valence = 4 - cluster.index;
  if (valence >= 3 && valence <= max_valence && curve::FaceBoundary(face).contains(cluster.centre))
    return {{cluster.centre, valence}};
  std::vector<NodeMark> nodes;
  for (const Vec2 x : node_ring(face, group, cluster, others)) nodes.push_back({x, cluster.index > 0 ? 3 : 5});
  return nodes;
}

std::vector<std::vector<NodeMark>> nodes_of_clusters(const CadFace& face, const std::vector<curve::Isometry>& group,
                                                     int max_valence, std::vector<Cluster>& clusters,
                                                     const std::function<std::vector<Vec2>(std::size_t)>& others) {
  for (Cluster& cluster : clusters) cluster.centre = onto_fixed_points(face, group, cluster.centre);
  const curve::Orbits orbits = curve::orbits(clusters.size(), group, [&](const curve::Isometry& g, int i, int j) {
    return clusters[i].index == clusters[j].index &&
           distance(g(clusters[i].centre), clusters[j].centre) < tolerance::same_point * face.diameter;
  });
  for (std::size_t i = 0; i < clusters.size(); ++i)
    clusters[i].centre = orbits.map[i](clusters[orbits.first[i]].centre);
  std::vector<std::vector<NodeMark>> nodes(clusters.size());
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const std::size_t first = orbits.first[i];
    if (first == i && clusters[i].index != 0)
      nodes[i] = cluster_nodes(face, group, max_valence, clusters[i], others(i));
    if (first == i) continue;
    nodes[i] = nodes[first];
    for (NodeMark& node : nodes[i]) node.position = orbits.map[i](node.position);
  }
  return nodes;
}

void resolve_clusters(const CadFace& face, int max_valence, CriticalPoints& points) {
  if (!points.clusters.empty()) resolve_clusters(face, curve::symmetries(face), max_valence, points);
}

void resolve_clusters(const CadFace& face, const std::vector<curve::Isometry>& group, int max_valence,
                      CriticalPoints& points) {
  const auto others = [&](std::size_t i) { return other_positions(points, i); };
  const std::vector<std::vector<NodeMark>> nodes = nodes_of_clusters(face, group, max_valence, points.clusters, others);
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
