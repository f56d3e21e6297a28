#pragma once
// A streamline of the guided cross angle: its launch, the steps of its integration, and how it ended.

#include <unordered_map>
#include <vector>

#include "field/evaluate.hpp"
#include "graph/build_graph.hpp"
#include "trace/launch.hpp"
#include "trace/step.hpp"

namespace quadrille::trace {

/// Of one line. Lines of 20 diameters need up to 18,000.
inline constexpr int max_stream_steps = 40000;

/// Where a line leaves the face. Curve -1: nowhere.
struct ExitPoint {
  int curve = -1;
  double t = 0;
  Vec2 position;
};

class Streamline {
 public:
  enum class End { boundary, node, length };
  /// A crossing of an element's edge, at arc length s.
  struct Pass {
    StreamState state;
    double s = 0;
  };
  /// What integration continues from.
  struct Front {
    StreamState state;
    double next_step = 0;                  ///< that is tried first
    std::unordered_map<int, Pass> passes;  ///< where the line last crossed each element edge, by 3 elem + edge
  };

  Launch launch;
  std::vector<StreamStep> steps;
  End end = End::length;
  graph::LineEnd reached;  ///< the node or the position on the boundary; neither for End::length
  Vec2 end_position;       ///< on the curve or the node, exactly
  double end_angle = 0;
  Front front;
  /// End::length: the line has returned to its crossing of an element's edge one lap before, within the hit distance
  /// and in the same direction: further laps repeat this one.
  bool is_limit_cycle = false;

  double length() const { return steps.empty() ? launch.radius : steps.back().s + steps.back().length; }
  /// Whether it has reached neither boundary nor node: it was too long, or it is a limit cycle.
  bool is_endless() const { return end == End::length; }
  /// Whether it has no end because its steps became too short: it cannot be continued.
  bool is_stuck() const { return is_endless() && steps.size() >= max_stream_steps; }
  /// Makes at() faster; to be called after steps were appended.
  void index_steps();
  /// Position at arc length s in [0, length()].
  Vec2 at(const field::FieldEvaluator& evaluator, double s) const;
  /// Position and unit direction.
  Vec2 at(const field::FieldEvaluator& evaluator, double s, Vec2& direction) const;
  /// Arc lengths at which steps begin, and the end.
  std::vector<double> step_ends() const;

 private:
  Vec2 lead_in(double s, Vec2& direction) const;
  const StreamStep& step_at(double s) const;

  std::vector<double> step_starts_;  // s of the steps that are indexed, near each other in memory
};

}  // namespace quadrille::trace
