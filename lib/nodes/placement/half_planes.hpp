#pragma once
// The nearest point of an intersection of half planes.

#include <optional>
#include <vector>

#include "base/vec2.hpp"

namespace quadrille::placement {

/// The points u with dot(normal, u) >= bound; `normal` is a unit vector.
struct HalfPlane {
  Vec2 normal;
  double bound = 0;
  bool may_miss = false;  ///< whether the bound is lowered where there is no room
};

/// The common point of all half planes that is nearest to `target`, if one is at most `reach` from it. Cost: the
/// number of half planes times that of those that stop it.
std::optional<Vec2> nearest_common_point(const std::vector<HalfPlane>& planes, Vec2 target, double reach);

/// As nearest_common_point; where there is no such point, all bounds that may be missed are lowered by the least equal
/// amount for which there is one, to `shortfall_tol`. The point 0 must be at most `reach` from `target` and keep all
/// bounds that may not be missed.
Vec2 nearest_point_with_least_shortfall(const std::vector<HalfPlane>& planes, Vec2 target, double reach,
                                        double shortfall_tol);

}  // namespace quadrille::placement
