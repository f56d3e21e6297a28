#include "features/feature_inward.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace quadrille::features {
namespace {

constexpr int halvings = 60;

/// The way of one node by its distance to the walls, which rises along it.
class Way {
 public:
  Way(const Walls& walls, const InwardMove& move, double goal) : walls_(&walls), move_(&move) {
    first_ = room(0);
    const double step = goal / 64;
    double s = 0, here = first_;
    while (here < goal) {
      const double next = room(s + step);
      if (next < here) break;
      s += step;
      here = next;
    }
    if (here >= goal)
      end_ = where(goal, s - step, s);
    else
      end_ = ridge(std::max(s - step, 0.0), s + step);
    last_ = room(end_);
  }

  double first() const { return first_; }
  double last() const { return last_; }
  /// Where the walls are `wall` away, clamped to the way.
  Vec2 at(double wall) const {
    if (wall <= first_) return point(0);
    return point(wall >= last_ ? end_ : where(wall, 0, end_));
  }

 private:
  Vec2 point(double s) const { return move_->start + s * move_->direction; }
  double room(double s) const { return walls_->distance_to(point(s)); }
  double where(double wall, double a, double b) const {
    for (int i = 0; i < halvings; ++i) {
      const double m = (a + b) / 2;
      (room(m) < wall ? a : b) = m;
    }
    return (a + b) / 2;
  }
  /// Where the distance is greatest between a and b.
  double ridge(double a, double b) const {
    for (int i = 0; i < 2 * halvings; ++i) {
      const double c = a + (b - a) / 3, d = b - (b - a) / 3;
      (room(c) < room(d) ? a : b) = room(c) < room(d) ? c : d;
    }
    return (a + b) / 2;
  }

  const Walls* walls_;
  const InwardMove* move_;
  double first_ = 0, last_ = 0, end_ = 0;
};

/// The least wall distance from `low` on at which `gap` (distance to another node less wall distance) is used up.
template <class Gap>
double limit(Gap gap, double low, double high) {
  if (gap(low) <= 0) return low;
  const int steps = 64;
  double a = low, b = high;
  for (int i = 1; i <= steps; ++i) {
    const double w = low + (high - low) * i / steps;
    if (gap(w) > 0) {
      a = w;
      if (i == steps) return high;
      continue;
    }
    b = w;
    break;
  }
  for (int i = 0; i < halvings; ++i) {
    const double m = (a + b) / 2;
    (gap(m) > 0 ? a : b) = m;
  }
  return a;
}

double farthest(const FeatureNodes& state, const std::vector<InwardMove>& moves, const std::vector<Way>& ways,
                size_t i) {
  double reach = ways[i].last();
  for (size_t k = 0; k < state.nodes.size(); ++k) {
    const auto other = std::find_if(moves.begin(), moves.end(),
                                    [&](const InwardMove& move) { return move.node == static_cast<int>(k); });
    if (moves[i].node == static_cast<int>(k)) continue;
    const auto place = [&](double w) {
      return other == moves.end() ? state.nodes[k].position : ways[other - moves.begin()].at(w);
    };
    if (distance(place(reach), ways[i].at(reach)) > 4 * state.size) continue;
    reach =
        std::min(reach, limit([&](double w) { return distance(ways[i].at(w), place(w)) - w; }, ways[i].first(), reach));
  }
  return reach;
}

}  // namespace

void move_inward(FeatureNodes& state, const Walls& walls, const std::vector<InwardMove>& moves) {
  std::vector<Way> ways;
  for (const InwardMove& move : moves) ways.emplace_back(walls, move, state.size);
  std::vector<Vec2> places;
  for (size_t i = 0; i < moves.size(); ++i) places.push_back(ways[i].at(farthest(state, moves, ways, i)));
  for (size_t i = 0; i < moves.size(); ++i) {
    FeatureNode& node = state.nodes[moves[i].node];
    const FeatureNode before = node;
    node.position = places[i];
    node.changed_by = ChangeKind::feature;
    record(
        state, ChangeKind::feature, {before}, {node},
        fmt::format("a convex fillet of radius {:.4g} is below the feature size {:.4g}: its node of valence 3 moves "
                    "inward, from {:.4g} to {:.4g} off the walls",
                    moves[i].radius, state.size, walls.distance_to(before.position), walls.distance_to(node.position)));
  }
}

}  // namespace quadrille::features
