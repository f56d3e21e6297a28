#pragma once
// All separatrices of a field, each traced to the length that a layout needs.

#include <vector>

#include "base/progress.hpp"
#include "model/critical_points.hpp"
#include "trace/advance.hpp"
#include "trace/mirror_axes.hpp"
#include "trace/trace_options.hpp"

namespace quadrille::trace {

/// Lines that are merged behind each other's nodes, or that stop at others, need not be traced to their ends: they are
/// traced in rounds of increasing length. A line that is continued keeps its earlier steps. Every function that follows
/// lines throws ComputeError as advance(), and as soon as they have more steps than TraceOptions::max_steps allows.
class LineTracer {
 public:
  /// `evaluator` must outlive the tracer. `nodes`: the positions of fixed_nodes. Launches all separatrices; if none
  /// starts in an annulus, cuts. Throws ComputeError as launch_all.
  LineTracer(const field::FieldEvaluator& evaluator, const CriticalPoints& points, const std::vector<Vec2>& nodes,
             const TraceOptions& options);

  /// Follows all lines that have no end yet to a length, at most options.max_length.
  /// Integrator::adams_bashforth follows them to options.max_length at once.
  void follow_all_to(double length, Progress* progress = nullptr);

  /// Continues one line that was traced before, by the Runge-Kutta integrator.
  void follow_to(int line, double length);

  /// Adds a line from a point of the boundary (a cut), followed to a length.
  void add_cut(int curve, double t, double length);

  /// A line in direction `angle` (radians) from a point of the domain, up to options.max_length; it is not added to
  /// lines().
  Streamline follow_from(Vec2 x, double angle) const;

  /// The length to which follow_all_to has traced lines without an end; 0: to the greatest length.
  double reach() const { return reach_ < max_length_ ? reach_ : 0; }
  double max_length() const { return max_length_; }
  /// Of all lines.
  std::size_t num_steps() const { return num_steps_; }

  const std::vector<Streamline>& lines() const { return lines_; }

 private:
  AdvanceOptions bounds(double length) const;
  void add_line(Streamline line);
  void follow_line(Streamline& line, const AdvanceOptions& options);
  void require_few_steps() const;
  Streamline traced(const PlannedLaunch& planned, const AdvanceOptions& options) const;

  const field::FieldEvaluator& evaluator_;
  PointGrid nodes_;
  TraceOptions options_;
  double max_length_ = 0, reach_ = 0;
  std::size_t num_steps_ = 0, max_num_steps_ = 0;
  std::vector<PlannedLaunch> launches_;  // of lines that have not been followed yet
  std::vector<Streamline> lines_;
};

}  // namespace quadrille::trace
