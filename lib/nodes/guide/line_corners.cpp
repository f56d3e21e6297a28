#include "guide/line_corners.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "curve/orbits.hpp"
#include "guide/tie_measures.hpp"
#include "guide/valence.hpp"

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

/// A corner at a tie starts with the larger valence, and so does a corner of 45 degrees.
Corner corner_at(const CadFace& face, int joint) {
  const double angle = face.joints[joint].interior_angle;
  Corner corner{joint, face.joints[joint].position, degrees(angle), 0, {face.previous_in_loop(joint), joint}};
  corner.valence = static_cast<int>(std::floor(angle / half_pi + 0.5 + tie_window / half_pi));
  if (is_tie(corner)) corner.source = NodeSource::line;
  return corner;
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

}  // namespace

LineCorners line_corners(const CadFace& face, const std::vector<curve::Isometry>& group) {
  LineCorners result;
  result.missing_index = 4 * face.euler_characteristic();
  for (int j = 0; j < face.num_curves(); ++j) {
    if (!face.joints[j].is_corner) continue;
    result.corners.push_back(corner_at(face, j));
    result.missing_index -= 2 - result.corners.back().valence;
  }
  const std::vector<TieOrbit> orbits = orbits_of_ties(face, group, result.corners);
  const std::optional<Choice> choice = cheapest(orbits, result.missing_index);
  if (!choice) return result;
  result.missing_index = 0;
  for (const std::size_t o : choice->orbits)
    for (const int c : orbits[o].corners) --result.corners[c].valence;
  return result;
}

}  // namespace quadrille::guide
