#include "topology/fewest_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

#include "base/angle.hpp"
#include "base/disjoint_sets.hpp"
#include "base/tolerance.hpp"
#include "curve/face_boundary.hpp"
#include "curve/nurbs.hpp"
#include "curve/symmetry.hpp"
#include "guide/resolve_clusters.hpp"
#include "guide/valence.hpp"
#include "placement/node_ledger.hpp"

namespace quadrille::topology {
namespace {

constexpr double least_angle = 40, greatest_angle = 140;  // degrees, of the blocks at a corner whose valence changes

/// Corners that isometries of the face map onto each other.
struct CornerOrbit {
  std::vector<int> corners;
  std::vector<int> valences;  ///< from which to choose, the present one first
};

/// The first that differs decides.
struct Cost {
  double defect = 0;
  double lengths = 0;  ///< minus the lengths of the sides adjacent to changed corners, in diameters
};
bool is_less(const Cost& a, const Cost& b) {
  return std::abs(a.defect - b.defect) > tolerance::tied ? a.defect < b.defect
                                                         : a.lengths < b.lengths - tolerance::tied;
}

struct Choice {
  Cost cost;
  std::vector<int> valences;  ///< of the orbits so far
};

std::vector<int> valences_of(const Corner& c) {
  std::vector<int> valences{c.valence};
  if (c.source == NodeSource::corner || c.source == NodeSource::divide || c.valence == 0) return valences;
  for (int v = 1; v <= guide::greatest_corner_valence; ++v) {
    const double block = c.angle_degrees / v;
    if (v != c.valence && block >= least_angle - tolerance::tied && block <= greatest_angle + tolerance::tied)
      valences.push_back(v);
  }
  return valences;
}

std::vector<CornerOrbit> orbits_of(const CadFace& face, const std::vector<Corner>& corners) {
  const auto is_image = [&](const curve::Isometry& g, int i, int j) {
    return distance(g(corners[i].position), corners[j].position) < tolerance::same_point * face.diameter;
  };
  std::vector<CornerOrbit> orbits;
  for (const std::vector<int>& set : curve::orbits(corners.size(), curve::symmetries(face), is_image).sets) {
    orbits.push_back({set, valences_of(corners[set.front()])});
    std::vector<int>& valences = orbits.back().valences;
    for (const int i : set)
      if (valences_of(corners[i]) != valences) valences.resize(1);  // one of them was prescribed
  }
  return orbits;
}

/// The cost of one corner with this valence.
Cost cost_of(const CadFace& face, const Corner& c, int valence) {
  if (valence == 0) return {};
  const double lengths = guide::side_length(face, c.curves[0]) + guide::side_length(face, c.curves[1]);
  return {guide::angle_defect(radians(c.angle_degrees), valence), valence == c.valence ? 0 : -lengths / face.diameter};
}

/// The best choice for each sum of 2 - V over all corners, by dynamic programming over the orbits.
std::map<int, Choice> best_choices(const CadFace& face, const std::vector<Corner>& corners,
                                   const std::vector<CornerOrbit>& orbits) {
  std::map<int, Choice> best{{0, {}}};
  for (const CornerOrbit& orbit : orbits) {
    std::map<int, Choice> next;
    for (const auto& [sum, choice] : best)
      for (const int valence : orbit.valences) {
        Choice with = choice;
        int new_sum = sum;
        for (const int i : orbit.corners) {
          const int kept = corners[i].valence, changed = valence == orbit.valences.front() ? kept : valence;
          const Cost cost = cost_of(face, corners[i], changed);
          with.cost = {with.cost.defect + cost.defect, with.cost.lengths + cost.lengths};
          new_sum += 2 - changed;
        }
        with.valences.push_back(valence);
        const auto known = next.find(new_sum);
        if (known == next.end() || is_less(with.cost, known->second.cost)) next[new_sum] = std::move(with);
      }
    best = std::move(next);
  }
  return best;
}

/// What corners and the nodes that can be removed must add up to.
int required_index(const CriticalPoints& points) {
  int index = points.index_sum_expected;
  for (const CriticalPoint& p : points.critical_points)
    if (p.source == NodeSource::divide) index -= p.index;
  for (const IrregularBoundaryPoint& b : points.boundary_nodes) index -= 2 - b.valence;
  return index;
}

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

/// The greatest distance of the corner's loop from the corner, as far as points of its curves tell.
double loop_size(const CadFace& face, int joint) {
  constexpr int points = 8;  // of each curve: a loop may be one curve that begins and ends at the corner
  const int l = face.loop_of(joint);
  double size = 0;
  for (int c = face.loop_offsets[l]; c < face.loop_offsets[l + 1]; ++c) {
    const double first = face.curves[c].begin(), last = face.curves[c].end();
    for (int k = 0; k < points; ++k)
      size = std::max(size, distance(curve::point(face.curves[c], first + (last - first) * k / points),
                                     face.joints[joint].position));
  }
  return size;
}

NodeMark node_behind(const CadFace& face, const Corner& corner) {
  const Joint& joint = face.joints[corner.joint];
  const Vec2 direction = unit(joint.tangent_out + joint.interior_angle / 2);
  const double start = tolerance::same_point * face.diameter;  // away from the corner itself
  const double clearance = curve::FaceBoundary(face).length_inside(joint.position + start * direction, direction);
  const double length = std::min(2 * loop_size(face, corner.joint), clearance / 2);
  return {joint.position + length * direction, 3};
}

std::vector<NodeMark> wake_nodes(const CadFace& face, const CriticalPoints& points) {
  std::vector<NodeMark> nodes;
  for (const Corner& c : points.corners)
    if (face.loop_of(c.joint) > 0 && c.valence == 3 && c.angle_degrees > 2 * guide::greatest_block_angle)
      nodes.push_back(node_behind(face, c));
  return nodes;
}

}  // namespace

std::vector<guide::CornerOverride> corners_without_nodes(const CadFace& face, const CriticalPoints& points) {
  const std::vector<CornerOrbit> orbits = orbits_of(face, points.corners);
  const std::map<int, Choice> best = best_choices(face, points.corners, orbits);
  const int required = required_index(points);
  const auto left = [&](int sum) { return std::abs(required - sum); };
  const auto chosen = std::min_element(best.begin(), best.end(), [&](const auto& a, const auto& b) {
    if (left(a.first) != left(b.first)) return left(a.first) < left(b.first);
    return is_less(a.second.cost, b.second.cost);
  });
  std::vector<guide::CornerOverride> corners;
  for (std::size_t k = 0; k < orbits.size(); ++k) {
    const int valence = chosen->second.valences[k];
    if (valence == orbits[k].valences.front()) continue;
    for (const int i : orbits[k].corners)
      corners.push_back({points.corners[i].curves[0], points.corners[i].curves[1], valence});
  }
  return corners;
}

bool has_opposite_nodes(const CriticalPoints& points, const std::vector<int>& region_elems) {
  const auto region_of = [&](const CriticalPoint& p) { return std::ranges::upper_bound(region_elems, p.elem); };
  for (const CriticalPoint& a : points.critical_points)
    for (const CriticalPoint& b : points.critical_points)
      if (are_opposite(a, b) && region_of(a) == region_of(b)) return true;
  return false;
}

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

bool set_wake_nodes(const CadFace& face, CriticalPoints& points) {
  placement::NodeEdit edit{ChangeKind::corner,
                           "an O-grid has a node of valence 3 in the wake of each sharp corner",
                           {},
                           wake_nodes(face, points)};
  int left = 0;
  for (std::size_t i = 0; i < points.critical_points.size(); ++i) {
    if (points.critical_points[i].source == NodeSource::divide) continue;
    left += points.critical_points[i].index;
    edit.removed.push_back(i);
  }
  if (edit.added.empty() || left != static_cast<int>(edit.added.size())) return false;
  placement::apply({edit}, points);
  return true;
}

}  // namespace quadrille::topology
