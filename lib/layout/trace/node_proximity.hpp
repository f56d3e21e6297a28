#pragma once
// The node nearest to a line, and the greatest step length there.

#include "base/point_grid.hpp"

namespace quadrille::trace {

class NodeProximity {
 public:
  /// `nodes` must outlive it. `origin`: where the line starts; equal to one of the nodes if the line starts at a node
  /// (its own). `is_at_origin`: the line is still near its own node.
  NodeProximity(const PointGrid& nodes, Vec2 origin, bool is_at_origin);

  /// Moves to x. Returns the nearest node, -1 if no node counts. The line's own node counts once the line has moved
  /// away from it.
  int move_to(Vec2 x);

  /// As move_to, but -1 if the nearest node is farther than `hit_distance`. A line has moved away from its own node at
  /// ten times this distance.
  int node_hit_at(Vec2 x, double hit_distance);

  /// Half the distance from the last x to the nearest node that is not the line's own. The field is singular there:
  /// the estimated error of a longer step may miss it.
  double longest_step() const { return longest_step_; }

 private:
  const PointGrid& nodes_;
  Vec2 origin_;
  int own_ = -1;  // the first node at the origin
  bool is_at_origin_;
  double longest_step_ = 0;
};

}  // namespace quadrille::trace
