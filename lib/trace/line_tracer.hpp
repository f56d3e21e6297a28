#pragma once
// All separatrices of a field, each followed as far as a layout needs it.

#include <vector>

#include "model/critical_points.hpp"
#include "trace/advance.hpp"
#include "trace/trace_options.hpp"

namespace quadrille::trace {

/// Lines that are merged behind each other's nodes, or that stop at others, need not be followed to their ends: they
/// are followed in rounds. A line that is followed farther keeps the steps it has.
class LineTracer {
 public:
  /// `evaluator` and `nodes` (the positions of fixed_nodes) must outlive the tracer. Launches all separatrices; cuts
  /// where nothing else starts in an annulus. Throws ComputeError as launch_all.
  LineTracer(const field::FieldEvaluator& evaluator, const CriticalPoints& points, const std::vector<Vec2>& nodes,
             const TraceOptions& options);

  /// Follows all lines that have no end yet to a length, at most options.max_length. Throws ComputeError as advance().
  /// Integrator::adams_bashforth follows them to options.max_length at once.
  void follow_all_to(double length);

  /// The same for one line that was followed before, by the Runge-Kutta integrator.
  void follow_to(int line, double length);

  /// Adds a line from a point of the boundary (a cut), followed to a length.
  void add_cut(int curve, double t, double length);

  /// The line in direction `angle` (radians) from a point of the domain, not one of lines(), as long as lines may be.
  Streamline follow_from(Vec2 x, double angle) const;

  /// How far lines without an end have been followed by follow_all_to; 0: as far as they may be.
  double reach() const { return reach_ < max_length_ ? reach_ : 0; }
  double max_length() const { return max_length_; }

  const std::vector<Streamline>& lines() const { return lines_; }

 private:
  AdvanceOptions bounds(double length) const;

  const field::FieldEvaluator& evaluator_;
  const std::vector<Vec2>& nodes_;
  TraceOptions options_;
  double max_length_ = 0, reach_ = 0;
  std::vector<Launch> launches_;  // of lines that have not been followed yet
  std::vector<Streamline> lines_;
};

}  // namespace quadrille::trace
