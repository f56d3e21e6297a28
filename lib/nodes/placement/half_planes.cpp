#include "placement/half_planes.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille::placement {
namespace {

constexpr double rounding = 1e-13;  // of sines, and of lengths relative to the greatest one; steps are far greater

double greatest_length(const std::vector<HalfPlane>& planes, Vec2 target) {
  double length = norm(target);
  for (const HalfPlane& plane : planes) length = std::max(length, std::abs(plane.bound));
  return length;
}

/// The point of the line of planes[i] nearest to the target among those of all earlier planes.
std::optional<Vec2> nearest_on_line(const std::vector<HalfPlane>& planes, std::size_t i, Vec2 target, double tol) {
  const HalfPlane& line = planes[i];
  const Vec2 foot = target + (line.bound - dot(line.normal, target)) * line.normal, along = left_of(line.normal);
  double low = -HUGE_VAL, high = HUGE_VAL;
  for (std::size_t j = 0; j < i; ++j) {
    const double slope = dot(planes[j].normal, along), rest = planes[j].bound - dot(planes[j].normal, foot);
    if (std::abs(slope) <= rounding) {
      if (rest > tol) return std::nullopt;
    } else if (slope > 0) {
      low = std::max(low, rest / slope);
    } else {
      high = std::min(high, rest / slope);
    }
  }
  if (low > high + tol) return std::nullopt;
  return foot + std::min(std::max(0.0, low), high) * along;
}

std::vector<HalfPlane> lowered(std::vector<HalfPlane> planes, double shortfall) {
  for (HalfPlane& plane : planes)
    if (plane.may_miss) plane.bound -= shortfall;
  return planes;
}

}  // namespace

std::optional<Vec2> nearest_common_point(const std::vector<HalfPlane>& planes, Vec2 target, double reach) {
  const double tol = rounding * greatest_length(planes, target);
  // If the nearest point of the planes so far is outside the next one, the new one is on its line.
  Vec2 nearest = target;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (dot(planes[i].normal, nearest) >= planes[i].bound - tol) continue;
    const std::optional<Vec2> moved = nearest_on_line(planes, i, target, tol);
    if (!moved || distance(*moved, target) > reach + tol) return std::nullopt;
    nearest = *moved;
  }
  return nearest;
}

Vec2 nearest_point_with_least_shortfall(const std::vector<HalfPlane>& planes, Vec2 target, double reach,
                                        double shortfall_tol) {
  if (const auto point = nearest_common_point(planes, target, reach)) return *point;
  double low = 0, high = 0;
  for (const HalfPlane& plane : planes)
    if (plane.may_miss) high = std::max(high, plane.bound);
  while (high - low > shortfall_tol / 2) {
    const double middle = (low + high) / 2;
    (nearest_common_point(lowered(planes, middle), target, reach) ? high : low) = middle;
  }
  // Within the tolerance the target decides, not rounding errors of nearly parallel lines.
  return nearest_common_point(lowered(planes, high + shortfall_tol / 2), target, reach).value_or(Vec2{});
}

}  // namespace quadrille::placement
