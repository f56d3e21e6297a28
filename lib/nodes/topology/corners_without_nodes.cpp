#include "topology/corners_without_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "curve/orbits.hpp"
#include "guide/admissible_valence.hpp"
#include "guide/tie_measures.hpp"

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

}  // namespace quadrille::topology
