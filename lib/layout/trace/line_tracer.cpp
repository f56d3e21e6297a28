#include "trace/line_tracer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "trace/adams_bashforth.hpp"
#include "trace/launch_all.hpp"

namespace quadrille::trace {
namespace {

// Relative to the diameter.
constexpr double relative_hit_distance = 1e-7;  // a line this near to a node ends in it
constexpr double relative_max_step = 0.05;      // unless the options prescribe another
constexpr double relative_fixed_step = 0.002;
constexpr double relative_launch_radius = 1e-6;  // of a line from a point that is no node

// Fewer lines are counted as so many in their mean number of steps: each of a few may be a long spiral.
constexpr std::size_t least_lines_of_mean = 100;

}  // namespace

LineTracer::LineTracer(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                       const std::vector<Vec2>& nodes, const TraceOptions& options)
    : evaluator_(evaluator), nodes_(nodes), options_(options) {
  const CadFace& face = evaluator.field().mesh.face;
  max_length_ = options.max_length * face.diameter;
  std::vector<Launch> launches = launch_all(evaluator, points);
  if (launches.empty() && face.num_loops() == 2) launches = launch_cuts(evaluator);
  launches_ = plan_launches(evaluator, mirror_axes(face, points), launches);
  max_num_steps_ = options.max_steps * std::max(launches_.size(), least_lines_of_mean);
}

AdvanceOptions LineTracer::bounds(double length) const {
  const double d = evaluator_.field().mesh.face.diameter;
  const bool is_fixed = options_.integrator == Integrator::adams_bashforth;
  const double step = options_.step > 0 ? options_.step : (is_fixed ? relative_fixed_step : relative_max_step) * d;
  return {options_.tolerance * d, step, std::min(length, max_length_), relative_hit_distance * d};
}

void LineTracer::follow_all_to(double length, Progress* progress) {
  const Progress::Part part(progress, "lines", static_cast<int>(lines_.size() + launches_.size()));
  const bool is_fixed = options_.integrator == Integrator::adams_bashforth;
  reach_ = is_fixed ? max_length_ : std::min(length, max_length_);
  const AdvanceOptions options = bounds(reach_);
  if (!is_fixed)
    for (Streamline& line : lines_) {
      follow_line(line, options);
      part.advance();
    }
  for (const PlannedLaunch& planned : launches_) {
    add_line(is_fixed ? advance_adams_bashforth(evaluator_, planned.launch, nodes_, options)
                      : traced(planned, options));
    part.advance();
  }
  launches_.clear();
}

void LineTracer::add_line(Streamline line) {
  num_steps_ += line.steps.size();
  lines_.push_back(std::move(line));
  require_few_steps();
}

void LineTracer::follow_line(Streamline& line, const AdvanceOptions& options) {
  num_steps_ -= line.steps.size();
  follow(evaluator_, line, nodes_, options);
  num_steps_ += line.steps.size();
  require_few_steps();
}

Streamline LineTracer::traced(const PlannedLaunch& planned, const AdvanceOptions& options) const {
  if (planned.straight) {
    Streamline line = advance(evaluator_, *planned.straight, nodes_, options);
    if (follows_field(evaluator_, line)) return line;
  }
  return advance(evaluator_, planned.launch, nodes_, options);
}

void LineTracer::follow_to(int line, double length) { follow_line(lines_[line], bounds(length)); }

void LineTracer::add_cut(int curve, double t, double length) {
  add_line(advance(evaluator_, launch_from_boundary(evaluator_, curve, t), nodes_, bounds(length)));
}

Streamline LineTracer::follow_from(Vec2 x, double angle) const {
  const double radius = relative_launch_radius * evaluator_.field().mesh.face.diameter;
  return advance(evaluator_, launch_line(evaluator_, -1, x, angle, radius, 1), nodes_, bounds(max_length_));
}

void LineTracer::require_few_steps() const {
  if (num_steps_ > max_num_steps_)
    throw ComputeError(fmt::format(
        "{} separatrices take {} steps, more than the {} allowed, and are not all complete: the field turns "
        "too fast, or raise --max-line-steps",
        lines_.size(), num_steps_, max_num_steps_));
}

}  // namespace quadrille::trace
