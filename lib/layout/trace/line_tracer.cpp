#include "trace/line_tracer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/tolerance.hpp"
#include "curve/symmetry.hpp"
#include "trace/launch.hpp"

namespace quadrille::trace {
namespace {

constexpr double most_deviation = 0.01;  // radians: of the field from a straight line

// Relative to the diameter.
struct TraceLengths {
  double hit_distance = 1e-7;   // a line this near to a node ends in it
  double max_step = 0.05;       // unless the options prescribe another
  double launch_radius = 1e-6;  // of a line from a point that is no node
};
constexpr TraceLengths relative{};

// Fewer lines are counted as so many in their mean number of steps: each of a few may be a long spiral.
constexpr std::size_t least_lines_of_mean = 100;

bool maps_nodes(const curve::Isometry& mirror, const std::vector<GraphNode>& nodes, double near) {
  const auto is_same = [](const GraphNode& a, const GraphNode& b) { return a.valence == b.valence; };
  return curve::images(nodes, mirror, near, is_same).size() == nodes.size();
}

// The first point of a straight launch: the foot on the axis of the one that the field prescribes.
void move_to_axis(const field::FieldEvaluator& evaluator, const MirrorAxis& axis, Launch& launch) {
  const Vec2 foot = axis.point + dot(launch.x - axis.point, axis.direction) * axis.direction;
  for (int i = 0; i < 2; ++i) {
    Vec2 x;
    Mat2 dx_dxi;
    evaluator.maps()[launch.elem].evaluate(launch.xi, x, dx_dxi);
    launch.xi += inverse(dx_dxi) * (foot - x);
  }
  launch.x = foot;
}

std::optional<Launch> straight_launch(const field::FieldEvaluator& evaluator, const std::vector<MirrorAxis>& axes,
                                      Launch launch) {
  const double near = tolerance::same_point * evaluator.field().mesh.face.diameter;
  const Vec2 start = unit(launch.angle);
  for (const MirrorAxis& axis : axes) {
    if (std::abs(cross(axis.direction, launch.origin - axis.point)) > near) continue;
    if (std::abs(cross(axis.direction, start)) > same_direction) continue;
    const Vec2 along = dot(axis.direction, start) > 0 ? axis.direction : -axis.direction;
    move_to_axis(evaluator, axis, launch);
    launch.angle += wrap_pi(angle_of(along) - launch.angle);
    launch.angle_there = launch.angle;
    launch.is_straight = true;
    return launch;
  }
  return std::nullopt;
}

// Whether the field has the line's direction at the ends of all of its steps: it need not be symmetric although face
// and nodes are.
bool follows_field(const field::FieldEvaluator& evaluator, const Streamline& line) {
  return std::all_of(line.steps.begin(), line.steps.end(), [&](const StreamStep& step) {
    const Vec2 xi = step.xi(step.length / step.h);
    const double angle = line.launch.angle_there;
    return std::abs(stream_state(evaluator, step.elem, xi, angle).angle - angle) <= most_deviation;
  });
}

}  // namespace

void TraceOptions::validate() const {
  if (!(tolerance > 0)) throw UsageError("the tolerance of the integrator must be positive");
  if (!(step >= 0 && merge_distance >= 0 && merge_angle >= 0))
    throw UsageError("step, merge distance and merge angle must not be negative");
  if (!(max_total_length > 0)) throw UsageError("the greatest total length of the lines must be positive");
  if (max_steps < 1) throw UsageError("the greatest number of steps of a line must be positive");
  if (!(max_length > 0)) throw UsageError("the greatest length of a line must be positive");
}

std::vector<MirrorAxis> mirror_axes(const CadFace& face, const CriticalPoints& points) {
  std::vector<MirrorAxis> axes;
  if (!points.hole_winding_offsets.empty()) return axes;
  const std::vector<GraphNode> nodes = fixed_nodes(face, points);
  for (const curve::Isometry& isometry : curve::symmetries(face))
    if (isometry.is_mirrored && maps_nodes(isometry, nodes, tolerance::same_point * face.diameter))
      axes.push_back({isometry.centre, unit(isometry.angle / 2)});
  return axes;
}

LineTracer::LineTracer(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                       const std::vector<Vec2>& nodes, const TraceOptions& options)
    : evaluator_(evaluator), nodes_(nodes), options_(options), axes_(mirror_axes(evaluator.field().mesh.face, points)) {
  const CadFace& face = evaluator.field().mesh.face;
  max_length_ = options.max_length * face.diameter;
  launches_ = launch_all(evaluator, points);
  if (launches_.empty() && face.num_loops() == 2) launches_ = launch_cuts(evaluator, axes_);
  max_num_steps_ = options.max_steps * std::max(launches_.size(), least_lines_of_mean);
}

AdvanceOptions LineTracer::bounds(double length) const {
  const double d = evaluator_.field().mesh.face.diameter;
  const double step = options_.step > 0 ? options_.step : relative.max_step * d;
  return {options_.tolerance * d, step, std::min(length, max_length_), relative.hit_distance * d};
}

std::vector<double> LineTracer::reaches() const {
  std::vector<double> reaches = reaches_;
  for (double& reach : reaches)
    if (reach >= max_length_) reach = 0;
  return reaches;
}

void LineTracer::follow_all_to(double length, Progress* progress) {
  const Progress::Part part(progress, "lines", static_cast<int>(lines_.size() + launches_.size()));
  for (int i = 0; i < static_cast<int>(lines_.size()); ++i, part.advance()) follow_to(i, length);
  const AdvanceOptions options = bounds(length);
  for (const Launch& launch : launches_) {
    add_line(traced(launch, options), length);
    part.advance();
  }
  launches_.clear();
}

void LineTracer::add_line(Streamline line, double reach) {
  num_steps_ += line.steps.size();
  lines_.push_back(std::move(line));
  reaches_.push_back(reach);
  require_few_steps();
}

void LineTracer::follow_to(int line, double length) {
  num_steps_ -= lines_[line].steps.size();
  follow(evaluator_, lines_[line], nodes_, bounds(length));
  num_steps_ += lines_[line].steps.size();
  reaches_[line] = length;
  require_few_steps();
}

Streamline LineTracer::traced(const Launch& launch, const AdvanceOptions& options) const {
  if (const std::optional<Launch> straight = straight_launch(evaluator_, axes_, launch)) {
    Streamline line = advance(evaluator_, *straight, nodes_, options);
    if (follows_field(evaluator_, line)) return line;
  }
  return advance(evaluator_, launch, nodes_, options);
}

void LineTracer::add_cut(int curve, double t, double length) {
  add_line(advance(evaluator_, launch_from_boundary(evaluator_, curve, t), nodes_, bounds(length)), length);
}

Streamline LineTracer::follow_from(Vec2 x, double angle) const {
  const double radius = relative.launch_radius * evaluator_.field().mesh.face.diameter;
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
