#include "guide/index_sum.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/position_text.hpp"
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
      "{} too {}",
      points.critical_points.size(), points.corners.size(), points.index_sum, points.index_sum_expected,
      std::abs(excess), excess > 0 ? "many" : "few");
  const auto from_tie = [](const Corner& c) { return degrees(tie_distance(radians(c.angle_degrees))); };
  const auto nearest = std::min_element(points.corners.begin(), points.corners.end(),
                                        [&](const Corner& a, const Corner& b) { return from_tie(a) < from_tie(b); });
  if (nearest != points.corners.end()) {
    message += fmt::format("; the least certain corner is the one of {:.6g} degrees at {}, valence {}",
                           nearest->angle_degrees, position_text(nearest->position + points.origin), nearest->valence);
  }
  throw ComputeError(message);
}

}  // namespace quadrille::guide
