#include "placement/half_planes.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille::placement {
namespace {

constexpr double on_line = 1e-13;   // relative to the greatest length: such points count as common ones
constexpr double parallel = 1e-12;  // sine of the angle between lines that have no crossing

double greatest_length(const std::vector<HalfPlane>& planes, Vec2 target) {
  double length = norm(target);
  for (const HalfPlane& plane : planes) length = std::max(length, std::abs(plane.bound));
  return length;
}

/// The target, the points of the lines nearest to it, and the crossings of the lines: one of them is the nearest common
/// point, if there is one.
std::vector<Vec2> candidates(const std::vector<HalfPlane>& planes, Vec2 target) {
  std::vector<Vec2> points{target};
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const HalfPlane& p = planes[i];
    points.push_back(target + (p.bound - dot(p.normal, target)) * p.normal);
    for (std::size_t j = 0; j < i; ++j) {
      const HalfPlane& q = planes[j];
      const double sine = cross(p.normal, q.normal);
      if (std::abs(sine) > parallel)
        points.push_back((q.bound * left_of(p.normal) - p.bound * left_of(q.normal)) / sine);
    }
  }
  return points;
}

std::vector<HalfPlane> lowered(std::vector<HalfPlane> planes, double shortfall) {
  for (HalfPlane& plane : planes)
    if (plane.may_miss) plane.bound -= shortfall;
  return planes;
}

}  // namespace

std::optional<Vec2> nearest_common_point(const std::vector<HalfPlane>& planes, Vec2 target, double reach) {
  const double tol = on_line * greatest_length(planes, target);
  std::optional<Vec2> best;
  double least = reach + tol;
  for (const Vec2 point : candidates(planes, target)) {
    const double way = distance(point, target);
    if (way > least) continue;
    const bool is_common = std::all_of(planes.begin(), planes.end(), [&](const HalfPlane& plane) {
      return dot(plane.normal, point) >= plane.bound - tol;
    });
    if (is_common) best = point, least = way;
  }
  return best;
}

Vec2 nearest_point_with_least_shortfall(const std::vector<HalfPlane>& planes, Vec2 target, double reach,
                                        double tolerance) {
  if (const auto point = nearest_common_point(planes, target, reach)) return *point;
  double low = 0, high = 0;
  for (const HalfPlane& plane : planes)
    if (plane.may_miss) high = std::max(high, plane.bound);
  while (high - low > tolerance / 2) {
    const double middle = (low + high) / 2;
    (nearest_common_point(lowered(planes, middle), target, reach) ? high : low) = middle;
  }
  // Within the tolerance the target decides, not rounding errors of nearly parallel lines.
  return nearest_common_point(lowered(planes, high + tolerance / 2), target, reach).value_or(Vec2{});
}

}  // namespace quadrille::placement
