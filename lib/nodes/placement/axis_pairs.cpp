#include "placement/axis_pairs.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "base/tolerance.hpp"

namespace quadrille::placement {
namespace {

using Pair = std::array<int, 2>;  // ascending

Pair pair_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

bool are_on_an_axis(const std::vector<NodeSymmetry>& group, const Pair& pair) {
  return std::ranges::any_of(group, [&](const NodeSymmetry& g) {
    return g.isometry.is_mirrored && g.image[pair[0]] == pair[0] && g.image[pair[1]] == pair[1];
  });
}

/// Whether each is nearer to the other than to any third node.
bool are_nearest(const CriticalPoints& points, const Pair& pair) {
  const auto& nodes = points.critical_points;
  const double apart = distance(nodes[pair[0]].position, nodes[pair[1]].position) * (1 + tolerance::tied);
  for (int j = 0; j < static_cast<int>(nodes.size()); ++j)
    for (const int k : pair)
      if (j != pair[0] && j != pair[1] && distance(nodes[j].position, nodes[k].position) <= apart) return false;
  return true;
}

/// Turns the pair; whether there is room for it.
bool turn(const curve::FaceBoundary& boundary, const Pair& pair, CriticalPoints& points) {
  Vec2 &a = points.critical_points[pair[0]].position, &b = points.critical_points[pair[1]].position;
  const Vec2 middle = (a + b) / 2, half = left_of(b - a) / 2;
  a = middle + half;
  b = middle - half;
  return boundary.contains(middle) && boundary.is_visible(middle, a) && boundary.is_visible(middle, b);
}

}  // namespace

std::vector<CriticalPoints> with_turned_pairs(const curve::FaceBoundary& boundary,
                                              const std::vector<NodeSymmetry>& group, const std::vector<bool>& may_move,
                                              const std::vector<bool>& is_stuck, const CriticalPoints& points) {
  std::vector<CriticalPoints> turned;
  std::set<Pair> known;
  const int n = static_cast<int>(points.critical_points.size());
  for (int k = 0; k < n; ++k)
    for (int l = k + 1; l < n; ++l) {
      const Pair pair{k, l};
      const bool may_turn = may_move[k] && may_move[l] && (is_stuck[k] || is_stuck[l]) &&
                            points.critical_points[k].valence == points.critical_points[l].valence;
      if (!may_turn || known.contains(pair) || !are_on_an_axis(group, pair) || !are_nearest(points, pair)) continue;
      std::set<Pair> images;
      for (const NodeSymmetry& g : group) images.insert(pair_of(g.image[k], g.image[l]));
      known.insert(images.begin(), images.end());
      CriticalPoints next = points;
      if (std::ranges::all_of(images, [&](const Pair& image) { return turn(boundary, image, next); }))
        turned.push_back(std::move(next));
    }
  return turned;
}

}  // namespace quadrille::placement
