#pragma once
// Integration of streamlines of the guided cross angle, from their launch to the boundary curve, a node or a bound.
//
// Integration runs in reference space, element by element: a step beyond the reference triangle is cut at the edge
// (root of its continuous extension) and continues in the neighbour at the same point of the shared edge. No search for
// elements is needed.

#include "base/point_grid.hpp"
#include "field/evaluate.hpp"
#include "trace/streamline.hpp"

namespace quadrille::trace {

struct AdvanceOptions {
  double tolerance = 1e-10;  ///< bound of a step's estimated error, a length
  double max_step = 0;       ///< a length
  double max_length = 0;     ///< of a line
  double hit_distance = 0;   ///< a line ends within this distance of a node, or of its position one lap before
};

/// The node nearest to a line, and the greatest step length there.
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

/// Integrates from the launch. A spiral that has reached its limit cycle, and a line of max_stream_steps steps, end
/// with End::length. Throws ComputeError with the position where the field has no direction (it vanishes away from all
/// nodes).
Streamline advance(const field::FieldEvaluator& evaluator, const Launch& launch, const PointGrid& nodes,
                   const AdvanceOptions& options);

/// Continues a line that ended with End::length, to the length of these options: the steps are the same as in a single
/// advance(). Other lines, and limit cycles, are not changed.
void follow(const field::FieldEvaluator& evaluator, Streamline& line, const PointGrid& nodes,
            const AdvanceOptions& options);

}  // namespace quadrille::trace
