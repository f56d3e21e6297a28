#pragma once
// Images of points under the isometries of a face, and symmetry orbits: items that these map onto each other, and that
// are therefore decided as a whole.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "curve/symmetry.hpp"

namespace quadrille::curve {

struct Orbits {
  std::vector<std::vector<int>> sets;  ///< the items of each orbit, ascending; the orbits by their first item
  std::vector<int> first;              ///< of each item: the first one of its orbit
  std::vector<Isometry> map;           ///< of each item: maps the first one of its orbit onto it
};

/// The orbits of the items 0, 1, ..., n - 1 under a group. is_image(g, i, j): whether the isometry g maps item i onto
/// item j. Each item is in one orbit; that of an item with no image but itself has this one only.
template <typename IsImage>
Orbits orbits(std::size_t n, const std::vector<Isometry>& group, const IsImage& is_image) {
  Orbits result{{}, std::vector<int>(n, -1), std::vector<Isometry>(n)};
  for (int i = 0; i < static_cast<int>(n); ++i) {
    if (result.first[i] >= 0) continue;
    result.first[i] = i;
    result.sets.push_back({i});
    for (int j = i + 1; j < static_cast<int>(n); ++j) {
      if (result.first[j] >= 0) continue;
      const auto g =
          std::find_if(group.begin(), group.end(), [&](const Isometry& each) { return is_image(each, i, j); });
      if (g == group.end()) continue;
      result.first[j] = i;
      result.map[j] = *g;
      result.sets.back().push_back(j);
    }
  }
  return result;
}

/// For each point the index of one at its image, for which is_same(point, other) holds: the nearest within `tol`, and
/// one to one, because corners on both sides of a slit are in one place. Empty if a point has no such image.
template <typename Point, typename IsSame>
std::vector<int> images(const std::vector<Point>& points, const Isometry& isometry, double tol, const IsSame& is_same) {
  std::vector<int> image;
  std::vector<bool> is_taken(points.size(), false);
  for (const Point& from : points) {
    const Vec2 x = isometry(from.position);
    int nearest = -1;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool is_candidate = !is_taken[i] && distance(points[i].position, x) <= tol && is_same(from, points[i]);
      if (is_candidate && (nearest < 0 || distance(points[i].position, x) < distance(points[nearest].position, x)))
        nearest = static_cast<int>(i);
    }
    if (nearest < 0) return {};
    is_taken[nearest] = true;
    image.push_back(nearest);
  }
  return image;
}

}  // namespace quadrille::curve
