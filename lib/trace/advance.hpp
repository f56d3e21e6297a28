#pragma once
// Streamlines of the guided cross angle, from their launch to the boundary curve, a node or a bound.
//
// Integration runs in reference space, element by element: a step that leaves the reference triangle is cut at the edge
// (root of its continuous extension) and goes on in the neighbour at the same place of the shared edge. No searches.

#include <unordered_map>
#include <vector>

#include "field/evaluate.hpp"
#include "trace/launch.hpp"
#include "trace/step.hpp"

namespace quadrille::trace {

inline constexpr int max_stream_steps = 100000;

struct AdvanceOptions {
  double tolerance = 1e-10;  ///< bound of a step's estimated error, a length
  double max_step = 0;       ///< a length
  double max_length = 0;     ///< of a line
  double hit_distance = 0;   ///< a line that comes as near as this to a node ends there, or to where it was before
};

class Streamline {
 public:
  enum class End { boundary, node, length };

  Launch launch;
  std::vector<StreamStep> steps;
  End end = End::length;
  int end_node = -1;  ///< End::node
  int curve = -1;     ///< End::boundary: the CAD curve and the parameter on it
  double t = 0;
  Vec2 end_position;  ///< on the curve or the node, exactly
  double end_angle = 0;
  StreamState front;  ///< End::length: where it goes on from, and the step it would try
  double next_step = 0;
  /// End::length: it has come back to an element's edge where it was a lap before, within the hit distance and in the
  /// same direction: more laps would tell nothing new.
  bool is_limit_cycle = false;
  struct Pass {
    StreamState state;
    double s = 0;
  };
  std::unordered_map<int, Pass> passes;  ///< where it last went over edges, by 3 elem + edge

  double length() const { return steps.empty() ? launch.radius : steps.back().s + steps.back().length; }
  /// Position at arc length s in [0, length()].
  Vec2 at(const field::FieldEvaluator& evaluator, double s) const;
  /// Position and unit direction.
  Vec2 at(const field::FieldEvaluator& evaluator, double s, Vec2& direction) const;
  /// Arc lengths at which steps begin, and the end.
  std::vector<double> step_ends() const;

 private:
  Vec2 lead_in(double s, Vec2& direction) const;
};

/// Integrates from the launch. A spiral ends, as by its length, where it has come to its limit cycle. Throws
/// ComputeError when the line cannot be followed: where the field vanishes at no node. A line also ends, as by its
/// length, after max_stream_steps.
Streamline advance(const field::FieldEvaluator& evaluator, const Launch& launch, const std::vector<Vec2>& nodes,
                   const AdvanceOptions& options);

/// Goes on with a line that a length ended, to the length of these options: the steps are those of one advance(). Not
/// round a limit cycle.
void follow(const field::FieldEvaluator& evaluator, Streamline& line, const std::vector<Vec2>& nodes,
            const AdvanceOptions& options);

}  // namespace quadrille::trace
