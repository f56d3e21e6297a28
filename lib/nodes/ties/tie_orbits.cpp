#include "ties/tie_orbits.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/angle.hpp"
#include "curve/orbits.hpp"
#include "guide/tie_measures.hpp"
#include "guide/valence.hpp"

namespace quadrille::ties {
namespace {

constexpr double symmetry_tolerance = 1e-3;  // diameters

std::optional<Tie> tie_at(const CadFace& face, int joint) {
  const double angle = face.joints[joint].interior_angle;
  const int smaller = static_cast<int>(std::floor(angle / half_pi));
  const double tie = (smaller + 0.5) * half_pi;
  if (!face.joints[joint].is_corner || std::abs(angle - tie) > guide::tie_window) return {};
  return Tie{joint, tie, smaller};
}

/// The tie nearest to x, if it is near enough to be an image; -1: none.
int tie_near(const CadFace& face, const std::vector<Tie>& ties, Vec2 x) {
  int nearest = -1;
  double least = 4 * symmetry_tolerance * face.diameter;
  for (std::size_t i = 0; i < ties.size(); ++i) {
    const double d = distance(face.joints[ties[i].joint].position, x);
    if (d < least) least = d, nearest = static_cast<int>(i);
  }
  return nearest;
}

/// The sets of ties that these isometries map onto each other; ties without a choice are left out.
std::vector<std::vector<int>> sets_of(const CadFace& face, const std::vector<Tie>& ties,
                                      const std::vector<curve::Isometry>& group) {
  const auto is_image = [&](const curve::Isometry& g, int i, int j) {
    return ties[i].smaller == ties[j].smaller && tie_near(face, ties, g(face.joints[ties[i].joint].position)) == j;
  };
  std::vector<std::vector<int>> sets = curve::orbits(ties.size(), group, is_image).sets;
  std::erase_if(sets, [&](const std::vector<int>& set) { return ties[set.front()].smaller == 0; });
  return sets;
}

/// The orbit of the tie at a joint, -1: no tie with a choice there.
int orbit_at(const TieOrbits& ties, int joint) {
  for (std::size_t u = 0; u < ties.units.size(); ++u)
    for (const int t : ties.units[u])
      if (ties.ties[t].joint == joint) return ties.unit2orbit[u];
  return -1;
}

}  // namespace

TieOrbits tie_orbits(const CadFace& face) {
  TieOrbits result;
  for (int j = 0; j < face.num_curves(); ++j)
    if (const auto tie = tie_at(face, j)) result.ties.push_back(*tie);
  if (result.ties.empty()) return result;
  std::vector<curve::Isometry> group = curve::symmetries(face, symmetry_tolerance);
  const std::vector<std::vector<int>> orbits = sets_of(face, result.ties, group);
  std::erase_if(group, [](const curve::Isometry& g) { return g.is_mirrored; });
  result.units = sets_of(face, result.ties, group);
  result.orbits.resize(orbits.size());
  for (std::size_t u = 0; u < result.units.size(); ++u)
    for (std::size_t o = 0; o < orbits.size(); ++o) {
      if (std::find(orbits[o].begin(), orbits[o].end(), result.units[u].front()) == orbits[o].end()) continue;
      result.orbits[o].push_back(static_cast<int>(u));
      result.unit2orbit.push_back(static_cast<int>(o));
    }
  return result;
}

std::vector<std::vector<int>> chamfers(const CadFace& face, const TieOrbits& ties) {
  std::vector<std::vector<int>> pairs;
  for (std::size_t u = 0; u < ties.units.size(); ++u)
    for (const int t : ties.units[u]) {
      const int out = ties.ties[t].joint, in = face.previous_in_loop(out);
      const bool is_out_shorter = guide::side_length(face, out) < guide::side_length(face, in);
      const int other = orbit_at(ties, is_out_shorter ? face.next_in_loop(out) : in);
      const int own = ties.unit2orbit[u];
      if (other >= 0 && other != own) pairs.push_back({std::min(own, other), std::max(own, other)});
    }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace quadrille::ties
