#include "trace/trace_lines.hpp"

#include <algorithm>

#include "trace/launch_all.hpp"

namespace quadrille {
namespace {

// Shares of the diameter.
constexpr double hit_share = 1e-7;       // as near to a node as this a line ends in it
constexpr double max_step_share = 0.05;  // unless the options say another one

}  // namespace

LineTracer::LineTracer(const FieldEvaluator& evaluator, const CriticalPoints& points, const std::vector<Vec2>& nodes,
                       const TraceOptions& options)
    : evaluator_(evaluator), nodes_(nodes) {
  const CadFace& face = evaluator.field().mesh.face;
  const double d = face.diameter;
  bounds_ = {options.tolerance * d, options.step > 0 ? options.step : max_step_share * d, 0, hit_share * d};
  max_length_ = options.max_length * d;
  launches_ = launch_all(evaluator, points);
  if (launches_.empty() && face.num_loops() == 2) launches_ = launch_cuts(evaluator);
  lines_.reserve(launches_.size());
}

void LineTracer::follow_to(double length) {
  bounds_.max_length = std::min(length, max_length_);
  for (Streamline& line : lines_) follow(evaluator_, line, nodes_, bounds_);
  for (size_t i = lines_.size(); i < launches_.size(); ++i)
    lines_.push_back(advance(evaluator_, launches_[i], nodes_, bounds_));
}

}  // namespace quadrille
