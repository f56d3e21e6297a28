#include "trace/node_proximity.hpp"

#include <cmath>

namespace quadrille::trace {

NodeProximity::NodeProximity(const PointGrid& nodes, Vec2 origin, bool is_at_origin)
    : nodes_(nodes), origin_(origin), is_at_origin_(is_at_origin) {
  const int nearest = nodes.nearest(origin, [](int) { return true; }).point;
  if (nearest >= 0 && nodes.points()[nearest] == origin) own_ = nearest;
}

int NodeProximity::move_to(Vec2 x) {
  const PointGrid::Nearest other = nodes_.nearest(x, [this](int n) { return nodes_.points()[n] != origin_; });
  longest_step_ = std::sqrt(other.distance2) / 2;
  if (own_ < 0 || is_at_origin_) return other.point;
  const double own_distance2 = norm2(x - nodes_.points()[own_]);
  const bool is_own_nearer =
      own_distance2 < other.distance2 || (own_distance2 == other.distance2 && own_ < other.point);
  return is_own_nearer ? own_ : other.point;
}

int NodeProximity::node_hit_at(Vec2 x, double hit_distance) {
  if (distance(x, origin_) > 10 * hit_distance) is_at_origin_ = false;
  const int node = move_to(x);
  return node >= 0 && distance(x, nodes_.points()[node]) <= hit_distance ? node : -1;
}

}  // namespace quadrille::trace
