#include "layout/strip_remedies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/angle.hpp"
#include "guide/valence.hpp"

namespace quadrille::layout {
namespace {

constexpr std::size_t max_corner_valences = 4;

struct Strip {
  std::vector<Corner> corners;  // by ascending joint
  std::vector<CriticalPoint> nodes;
};

Strip strip_of(const ArcGraph& t_mesh, const std::vector<int>& arcs, const CriticalPoints& points) {
  Strip strip;
  std::set<int> ends, joints;
  for (const int a : arcs) ends.insert({t_mesh.arcs[a].from, t_mesh.arcs[a].to});
  for (const int n : ends) {
    const GraphNode& node = t_mesh.nodes[n];
    if (node.kind == NodeKind::corner) joints.insert(node.curve);  // the outgoing curve has the number of its joint
    if (node.kind != NodeKind::irregular) continue;
    for (const CriticalPoint& p : points.critical_points)
      if (p.position == node.position) strip.nodes.push_back(p);
  }
  for (const Corner& c : points.corners)
    if (joints.count(c.joint) > 0) strip.corners.push_back(c);
  return strip;
}

bool has_change(const CriticalPoints& points, ChangeKind kind, const std::vector<Corner>& corners) {
  const auto concerns = [&](const NodeMark& mark) {
    return mark.location == NodeLocation::corner &&
           std::any_of(corners.begin(), corners.end(), [&](const Corner& c) { return c.position == mark.position; });
  };
  return std::any_of(points.changes.begin(), points.changes.end(), [&](const NodeChange& change) {
    return change.kind == kind && std::any_of(change.after.begin(), change.after.end(), concerns);
  });
}

// Nodes that were placed or that critpoints never moves stay where they are.
bool may_move(const CriticalPoint& node) {
  return node.source != NodeSource::divide && node.source != NodeSource::place;
}

struct CornerChange {
  std::string option;
  double added_defect = 0;
};

std::vector<CornerChange> corner_changes(const std::vector<Corner>& corners) {
  std::vector<CornerChange> changes;
  for (const Corner& c : corners) {
    const int valence = c.angle_degrees > 180 ? c.valence - 1 : c.valence + 1;
    if (valence < 1 || !guide::is_admissible_valence(c.angle_degrees, valence)) continue;
    const double angle = radians(c.angle_degrees), now = c.valence > 0 ? guide::angle_defect(angle, c.valence) : 0;
    changes.push_back({fmt::format("--corner-valence {}:{}={}", c.curves[0], c.curves[1], valence),
                       guide::angle_defect(angle, valence) - now});
  }
  constexpr double equal = 1e-6;
  std::stable_sort(changes.begin(), changes.end(), [](const CornerChange& a, const CornerChange& b) {
    return std::round(a.added_defect / equal) < std::round(b.added_defect / equal);
  });
  if (changes.size() > max_corner_valences) changes.resize(max_corner_valences);
  return changes;
}

}  // namespace

std::vector<std::string> strip_remedies(const ArcGraph& t_mesh, const std::vector<int>& strip_arcs,
                                        const CriticalPoints& points) {
  const Strip strip = strip_of(t_mesh, strip_arcs, points);
  std::vector<std::string> remedies;
  if (has_change(points, ChangeKind::absorb, strip.corners)) remedies.emplace_back("--corner-absorb 0");
  if (has_change(points, ChangeKind::line, strip.corners)) remedies.emplace_back("--ties field");
  if (std::any_of(strip.nodes.begin(), strip.nodes.end(), may_move)) remedies.emplace_back("--place energy");
  for (const CornerChange& change : corner_changes(strip.corners)) remedies.push_back(change.option);
  return remedies;
}

}  // namespace quadrille::layout
