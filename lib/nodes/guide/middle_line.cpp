#include "guide/middle_line.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/bracketed_root.hpp"
#include "base/tolerance.hpp"
#include "curve/arc_length.hpp"
#include "curve/nurbs.hpp"
#include "placement/clearance.hpp"

namespace quadrille::guide {
namespace {

// Steps along curved sides. Their lengths grow from the corner on, as the width of the wedge does: a step of length s
// leaves the middle of sides of curvature k by k s^2 / 8.
constexpr int num_steps = 64;

// Part of the wedge's width that a point in its middle must be away from the boundary: in a wedge without holes it is
// about half.
constexpr double least_clearance = 0.25;

bool is_straight(const Nurbs& curve, double tol) {
  const Vec2 from = curve.poles.front(), chord = curve.poles.back() - from;
  return norm(chord) > 0 && std::all_of(curve.poles.begin(), curve.poles.end(), [&](Vec2 pole) {
           return std::abs(cross(chord, pole - from)) <= tol * norm(chord);
         });
}

Vec2 direction_of(Vec2 from, Vec2 to) { return (to - from) / distance(from, to); }

// One side of a corner, followed from it. The curve must outlive the object.
class Side {
 public:
  Side(const Nurbs& curve, bool starts_at_corner)
      : curve_(&curve), length_(curve), starts_at_corner_(starts_at_corner), corner_(at(0)) {}

  double length() const { return length_.total(); }
  Vec2 at(double along) const {
    return curve::point(*curve_, length_.parameter(starts_at_corner_ ? along : length_.total() - along));
  }
  double distance_at(double along) const { return distance(at(along), corner_); }

  // The greatest length up to `limit` at which the side still leads away from the corner.
  double monotone_length(double limit) const {
    double previous = 0;
    for (int i = 1; i <= num_steps; ++i) {
      const double here = distance_at(limit * i / num_steps);
      if (here <= previous) return limit * (i - 1) / num_steps;
      previous = here;
    }
    return limit;
  }

  // Within `limit`, a monotone length.
  Vec2 at_distance(double radius, double limit) const {
    return at(bisect([&](double along) { return distance_at(along) - radius; }, 0, limit));
  }

 private:
  const Nurbs* curve_;
  curve::ArcLength length_;
  bool starts_at_corner_;
  Vec2 corner_;
};

// Midpoints at equal distances from the corner, up to which both sides lead away from it.
void add_midpoints(const Side& in, const Side& out, double shorter, MiddleLine& line) {
  const double end_in = in.monotone_length(shorter), end_out = out.monotone_length(shorter);
  const double reach = std::min(in.distance_at(end_in), out.distance_at(end_out));
  for (int i = 1; i <= num_steps; ++i) {
    const double radius = reach * std::pow(static_cast<double>(i) / num_steps, 2);
    const Vec2 a = in.at_distance(radius, end_in), b = out.at_distance(radius, end_out);
    line.points.push_back(0.5 * (a + b));
    line.widths.push_back(distance(a, b));
  }
}

}  // namespace

MiddleLine middle_line(const CadFace& face, int joint) {
  const Joint& corner = face.joints[joint];
  const int previous = face.previous_in_loop(joint);
  const Nurbs &in = face.curves[previous], &out = face.curves[joint];
  const Side side_in(in, false), side_out(out, true);
  MiddleLine line{
      {corner.position}, {0}, std::min(side_in.length(), side_out.length()) * (previous == joint ? 0.5 : 1)};
  const double tol = tolerance::round_off * face.diameter;
  if (is_straight(in, tol) && is_straight(out, tol)) {
    line.points.push_back(corner.position + line.side * unit(corner.tangent_out + corner.interior_angle / 2));
    line.widths.push_back(2 * line.side * std::sin(corner.interior_angle / 2));
  } else {
    add_midpoints(side_in, side_out, line.side, line);
  }
  return line;
}

double length_inside(const CadFace& face, const MiddleLine& line) {
  const std::size_t last = line.points.size() - 1;
  const Vec2 direction = direction_of(line.points[last - 1], line.points[last]);
  if (last == 1) {
    const double off = tolerance::same_point * face.diameter;  // rays from the corner itself meet its sides
    return off + placement::clearance_along(face, line.points[0] + off * direction, direction);
  }
  double length = 0;
  for (std::size_t i = 1; i <= last; ++i) {
    if (placement::signed_clearance(face, line.points[i]) < least_clearance * line.widths[i]) return length;
    length += distance(line.points[i - 1], line.points[i]);
  }
  return length + placement::clearance_along(face, line.points[last], direction);
}

double length_of_small_turn(const MiddleLine& line, double limit) {
  double length = 0;
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    const Vec2 first = line.points[1] - line.points[0], here = line.points[i] - line.points[i - 1];
    const double turn = std::abs(std::atan2(cross(first, here), dot(first, here)));
    const double end = length + norm(here);
    if (turn > limit * line.widths[i] / end) return length;
    length = end;
  }
  return INFINITY;
}

Vec2 point_at(const MiddleLine& line, double length) {
  std::size_t i = 1;
  for (; i + 1 < line.points.size(); ++i) {
    const double step = distance(line.points[i - 1], line.points[i]);
    if (length <= step) break;
    length -= step;
  }
  return line.points[i - 1] + length * direction_of(line.points[i - 1], line.points[i]);
}

}  // namespace quadrille::guide
