#include "trace/node_proximity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille::trace {

int NodeProximity::move_to(Vec2 x) {
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity(), least_other = least;
  for (size_t n = 0; n < nodes_.size(); ++n) {
    const double distance2 = norm2(x - nodes_[n]);
    const bool is_own = nodes_[n] == origin_;
    if (!is_own) least_other = std::min(least_other, distance2);
    if (distance2 < least && !(is_own && is_at_origin_)) least = distance2, nearest = static_cast<int>(n);
  }
  longest_step_ = std::sqrt(least_other) / 2;
  return nearest;
}

int NodeProximity::node_hit_at(Vec2 x, double hit_distance) {
  if (distance(x, origin_) > 10 * hit_distance) is_at_origin_ = false;
  const int node = move_to(x);
  return node >= 0 && distance(x, nodes_[node]) <= hit_distance ? node : -1;
}

}  // namespace quadrille::trace
