#include "trace/trace_lines.hpp"

#include <algorithm>

#include "trace/adams_bashforth.hpp"
#include "trace/launch_all.hpp"

namespace quadrille::trace {
namespace {

// Shares of the diameter.
constexpr double hit_share = 1e-7;       // as near to a node as this a line ends in it
constexpr double max_step_share = 0.05;  // unless the options say another one
constexpr double fixed_step_share = 0.002;

}  // namespace

LineTracer::LineTracer(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                       const std::vector<Vec2>& nodes, const TraceOptions& options)
    : evaluator_(evaluator), nodes_(nodes), is_adams_bashforth_(options.integrator == "ab4") {
  const CadFace& face = evaluator.field().mesh.face;
  const double d = face.diameter;
  const double share = is_adams_bashforth_ ? fixed_step_share : max_step_share;
  bounds_ = {options.tolerance * d, options.step > 0 ? options.step : share * d, 0, hit_share * d};
  max_length_ = options.max_length * d;
  launches_ = launch_all(evaluator, points);
  if (launches_.empty() && face.num_loops() == 2) launches_ = launch_cuts(evaluator);
  lines_.reserve(launches_.size());
}

void LineTracer::follow_to(double length) {
  if (is_adams_bashforth_) return follow_by_adams_bashforth();
  bounds_.max_length = std::min(length, max_length_);
  for (Streamline& line : lines_) follow(evaluator_, line, nodes_, bounds_);
  for (size_t i = lines_.size(); i < launches_.size(); ++i)
    lines_.push_back(advance(evaluator_, launches_[i], nodes_, bounds_));
}

void LineTracer::follow_by_adams_bashforth() {
  bounds_.max_length = max_length_;
  for (size_t i = lines_.size(); i < launches_.size(); ++i)
    lines_.push_back(advance_adams_bashforth(evaluator_, launches_[i], nodes_, bounds_));
}

}  // namespace quadrille::trace
