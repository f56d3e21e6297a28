#pragma once
// All separatrices of a field, followed as far as somebody wants to know.

#include <vector>

#include "model/critical_points.hpp"
#include "trace/advance.hpp"
#include "trace/trace_options.hpp"

namespace quadrille::trace {

/// Lines that are merged behind each other's nodes, or stopped, need not go on for ever: they are followed in rounds.
class LineTracer {
 public:
  /// `evaluator` and `nodes` (the positions of fixed_nodes) must outlive the tracer. Launches, cuts where nothing else
  /// starts in an annulus. Throws ComputeError as launch_all.
  LineTracer(const field::FieldEvaluator& evaluator, const CriticalPoints& points, const std::vector<Vec2>& nodes,
             const TraceOptions& options);

  /// Follows all lines that have no end yet to a length, at most options.max_length. Throws ComputeError as advance().
  /// Lines keep their address and what they had. The integrator "ab4" goes all the way at once.
  void follow_to(double length);

  /// How far lines without an end have been followed; 0: as far as they may be.
  double reach() const { return bounds_.max_length < max_length_ ? bounds_.max_length : 0; }

  const std::vector<Streamline>& lines() const { return lines_; }

 private:
  void follow_by_adams_bashforth();

  const field::FieldEvaluator& evaluator_;
  const std::vector<Vec2>& nodes_;
  bool is_adams_bashforth_;
  AdvanceOptions bounds_;
  double max_length_ = 0;
  std::vector<Launch> launches_;
  std::vector<Streamline> lines_;
};

}  // namespace quadrille::trace
