#include "guide/index_sum.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "guide/valence.hpp"

namespace quadrille::guide {

int index_sum_with_clusters(const CriticalPoints& points) {
  int sum = index_sum_of(points);
  for (const Cluster& cluster : points.clusters) sum += cluster.index;
  return sum;
}

void require_index_sum(const CriticalPoints& points) {
  const int excess = points.index_sum - points.index_sum_expected;
  if (excess == 0) return;
  std::string message = fmt::format(
      "the sum of 4 - V over {} critical points and of 2 - V over {} corners is {}, but it must be {} for this face: "
      "{} too "
      "{}",
      points.critical_points.size(), points.corners.size(), points.index_sum, points.index_sum_expected,
      std::abs(excess), excess > 0 ? "many" : "few");
  const auto from_tie = [](const Corner& c) { return degrees(tie_distance(radians(c.angle_degrees))); };
  const auto nearest = std::min_element(points.corners.begin(), points.corners.end(),
                                        [&](const Corner& a, const Corner& b) { return from_tie(a) < from_tie(b); });
  if (nearest != points.corners.end()) {
    const Vec2 x = nearest->position + points.origin;
    message += fmt::format("; the least certain corner is the one of {:.6g} degrees at ({:.6g}, {:.6g}), valence {}",
                           nearest->angle_degrees, x.x, x.y, nearest->valence);
  }
  throw ComputeError(message);
}

}  // namespace quadrille::guide
