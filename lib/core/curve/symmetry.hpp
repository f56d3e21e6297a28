#pragma once
// The isometries of the plane that map a face onto itself, images of points under them, and symmetry orbits.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/vec2.hpp"
#include "model/cad_face.hpp"

namespace quadrille::curve {

/// A rotation of the plane about a point.
struct Rotation {
  Vec2 centre;
  double angle = 0;  ///< radians

  Vec2 of_vector(Vec2 v) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y};
  }
  Vec2 of(Vec2 x) const { return centre + of_vector(x - centre); }
  Rotation inverse() const { return {centre, -angle}; }
};

/// x -> centre + R(angle) [mirror] (x - centre), mirror: the reflection (x, y) -> (x, -y), applied first. A mirrored
/// isometry is the reflection at the line through the centre in the direction angle / 2.
struct Isometry {
  Vec2 centre;
  double angle = 0;  ///< radians
  bool is_mirrored = false;

  Vec2 operator()(Vec2 x) const;
  /// The image of a direction: the same map without the centre.
  Vec2 turned(Vec2 direction) const;
};

/// The largest finite group that can be detected: identity first, then rotations by ascending angle, then mirrored
/// isometries by ascending angle. Their common centre is the face's centroid. A face bounded by concentric circles has
/// infinitely many; for it the dihedral group of order 8 with one axis through joint 0 is returned. An isometry is
/// accepted if it maps every curve onto the boundary within `tolerance` diameters. This is tested for the smallest
/// rotation and for one mirrored isometry; the others are their products, exact to round-off. Cost: a projection of a
/// few points of each knot span for each candidate that the crossings of one circle about the centre do not rule out.
std::vector<Isometry> symmetries(const CadFace& face, double tolerance = 1e-7);

// Images of points under the isometries of a face, and symmetry orbits: items that these map onto each other, and that
// are therefore decided as a whole.

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
