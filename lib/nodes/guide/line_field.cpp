#include "guide/line_field.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "curve/symmetry.hpp"
#include "guide/resolve_clusters.hpp"
#include "guide/valence.hpp"
#include "placement/node_ledger.hpp"
#include "placement/smooth_boundary_distance.hpp"

namespace quadrille::guide {
namespace {

/// The costs to minimise; the first that differs decides: angle defect, minus adjacent lengths, minus distances.
using Cost = std::array<double, 3>;

Cost operator+(const Cost& a, const Cost& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

bool is_less(const Cost& a, const Cost& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::abs(a[i] - b[i]) > tolerance::tied) return a[i] < b[i];
  return false;
}

bool is_tie(const Corner& corner) {
  return corner.angle_degrees > 90 && tie_distance(radians(corner.angle_degrees)) < tie_window;
}

/// The cost of the smaller valence at a corner.
Cost cost_of_smaller(const CadFace& face, Vec2 centroid, const Corner& c) {
  const double angle = radians(c.angle_degrees);
  return {angle_defect(angle, c.valence - 1) - angle_defect(angle, c.valence),
          -(side_length(face, c.curves[0]) + side_length(face, c.curves[1])) / face.diameter,
          -distance(c.position, centroid) / face.diameter};
}

/// Ties that isometries of the face map onto each other.
struct TieOrbit {
  std::vector<int> corners;
  Cost cost{};
};

std::vector<TieOrbit> orbits_of_ties(const CadFace& face, const std::vector<curve::Isometry>& group,
                                     const std::vector<Corner>& corners) {
  const auto is_image = [&](const curve::Isometry& g, int i, int j) {
    return is_tie(corners[i]) && is_tie(corners[j]) &&
           distance(g(corners[i].position), corners[j].position) < tolerance::same_point * face.diameter;
  };
  std::vector<TieOrbit> orbits;
  for (const std::vector<int>& set : curve::orbits(corners.size(), group, is_image).sets) {
    if (!is_tie(corners[set.front()])) continue;
    orbits.push_back({set});
    const Cost cost = cost_of_smaller(face, group[0].centre, corners[set.front()]);
    for (std::size_t k = 0; k < set.size(); ++k) orbits.back().cost = orbits.back().cost + cost;
  }
  return orbits;
}

struct Choice {
  Cost cost{};
  std::vector<std::size_t> orbits;  ///< those with the smaller valence
};

/// The cheapest choice of orbits with `count` corners in total, by dynamic programming over orbits and smaller counts.
std::optional<Choice> cheapest(const std::vector<TieOrbit>& orbits, int count) {
  if (count < 0) return {};
  std::vector<std::optional<Choice>> best(count + 1);
  best[0] = Choice{};
  for (std::size_t o = 0; o < orbits.size(); ++o) {
    const int size = static_cast<int>(orbits[o].corners.size());
    for (int n = count; n >= size; --n) {
      if (!best[n - size]) continue;
      Choice with = *best[n - size];
      with.cost = with.cost + orbits[o].cost;
      with.orbits.push_back(o);
      if (!best[n] || is_less(with.cost, best[n]->cost)) best[n] = with;
    }
  }
  return best[count];
}

placement::NodeEdit corner_edit(const Corner& corner) {
  return {ChangeKind::line,
          fmt::format("the zeros of the field cannot be isolated: valence {} by rule at the corner of {:.6g} degrees",
                      corner.valence, corner.angle_degrees),
          {{corner.joint, corner.valence}}};
}

/// The centre of all nodes: a point that is invariant under the symmetries of the face.
Vec2 middle_of(const CadFace& face, const std::vector<curve::Isometry>& group) {
  const bool has_rotations = group.size() > 1 && !group[1].is_mirrored;
  return has_rotations ? group[0].centre : placement::most_interior_point(face, group);
}

placement::NodeEdit nodes_edit(const CadFace& face, const std::vector<curve::Isometry>& group, int max_valence,
                               int index) {
  Cluster cluster;
  cluster.centre = middle_of(face, group);
  cluster.index = index;
  return {ChangeKind::line,
          fmt::format("no choice of corner valences that is as symmetric as the face has the right index sum: nodes "
                      "inside have the missing index {}",
                      index),
          {},
          cluster_nodes(face, group, max_valence, cluster, {})};
}

}  // namespace

LineCorners line_corners(const CadFace& face, const std::vector<curve::Isometry>& group) {
  LineCorners result;
  result.corners = corner_valences_by_angle(face).corners;
  result.missing_index = 4 * face.euler_characteristic();
  for (Corner& c : result.corners) {
    // A corner at a tie starts with the larger valence, and so does a corner of 45 degrees.
    c.valence = static_cast<int>(std::floor((radians(c.angle_degrees) + tie_window) / half_pi + 0.5));
    if (is_tie(c)) c.source = NodeSource::line;
    result.missing_index -= 2 - c.valence;
  }
  const std::vector<TieOrbit> orbits = orbits_of_ties(face, group, result.corners);
  const std::optional<Choice> choice = cheapest(orbits, result.missing_index);
  if (!choice) return result;
  result.missing_index = 0;
  for (const std::size_t o : choice->orbits)
    for (const int c : orbits[o].corners) --result.corners[c].valence;
  return result;
}

CriticalPoints line_field_points(const CadFace& face, int max_valence) {
  const std::vector<curve::Isometry> group = curve::symmetries(face);
  const LineCorners chosen = line_corners(face, group);
  CriticalPoints points;
  points.form = NodeForm::phase;
  points.origin = face.origin;
  points.corners = chosen.corners;
  std::vector<placement::NodeEdit> edits;
  for (const Corner& corner : chosen.corners)
    if (corner.source == NodeSource::line) edits.push_back(corner_edit(corner));
  if (chosen.missing_index != 0) edits.push_back(nodes_edit(face, group, max_valence, chosen.missing_index));
  placement::apply(edits, points);
  points.index_sum_expected = 4 * face.euler_characteristic();
  return points;
}

}  // namespace quadrille::guide
