#include "trace/mirror_axes.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "curve/orbits.hpp"
#include "trace/fixed_nodes.hpp"

namespace quadrille::trace {
namespace {

constexpr double same_position = 1e-6;   // relative to the diameter
constexpr double along_axis = 1e-3;      // radians: two lines of one node are never as near
constexpr double most_deviation = 0.01;  // radians

bool maps_nodes(const curve::Isometry& mirror, const std::vector<graph::FixedNode>& nodes, double near) {
  const auto is_same = [](const graph::FixedNode& a, const graph::FixedNode& b) { return a.valence == b.valence; };
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
  const double near = same_position * evaluator.field().mesh.face.diameter;
  const Vec2 start = unit(launch.angle);
  for (const MirrorAxis& axis : axes) {
    if (std::abs(cross(axis.direction, launch.origin - axis.point)) > near) continue;
    if (std::abs(cross(axis.direction, start)) > along_axis) continue;
    const Vec2 along = dot(axis.direction, start) > 0 ? axis.direction : -axis.direction;
    move_to_axis(evaluator, axis, launch);
    launch.angle += wrap_pi(angle_of(along) - launch.angle);
    launch.angle_there = launch.angle;
    launch.is_straight = true;
    return launch;
  }
  return std::nullopt;
}

}  // namespace

std::vector<MirrorAxis> mirror_axes(const CadFace& face, const CriticalPoints& points) {
  std::vector<MirrorAxis> axes;
  if (!points.hole_winding_offsets.empty()) return axes;
  const std::vector<graph::FixedNode> nodes = fixed_nodes(face, points);
  for (const curve::Isometry& isometry : curve::symmetries(face))
    if (isometry.is_mirrored && maps_nodes(isometry, nodes, same_position * face.diameter))
      axes.push_back({isometry.centre, unit(isometry.angle / 2)});
  return axes;
}

std::vector<PlannedLaunch> plan_launches(const field::FieldEvaluator& evaluator, const std::vector<MirrorAxis>& axes,
                                         const std::vector<Launch>& launches) {
  std::vector<PlannedLaunch> planned;
  for (const Launch& launch : launches) planned.push_back({launch, straight_launch(evaluator, axes, launch)});
  return planned;
}

bool follows_field(const field::FieldEvaluator& evaluator, const Streamline& line) {
  return std::all_of(line.steps.begin(), line.steps.end(), [&](const StreamStep& step) {
    const Vec2 xi = step.xi(step.length / step.h);
    const double angle = line.launch.angle_there;
    return std::abs(stream_state(evaluator, step.elem, xi, angle).angle - angle) <= most_deviation;
  });
}

}  // namespace quadrille::trace
