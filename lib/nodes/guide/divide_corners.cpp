#include "guide/divide_corners.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/bracketed_root.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "base/warning_codes.hpp"
#include "curve/chain.hpp"
#include "curve/face_boundary.hpp"
#include "curve/nurbs.hpp"
#include "guide/valence.hpp"
#include "placement/node_ledger.hpp"
#include "surface/positions.hpp"

namespace quadrille::guide {
namespace {

struct DivisionRules {
  // Greatest distance of the node of a division from its corner.
  double part_of_clearance = 0.25;  // of the length of the middle line inside the face
  double part_of_side = 0.5;        // of the shorter side
  double part_of_distance = 0.5;    // of the distance to any other node
  // The middle line turns by at most this multiple of the angle under which the corner sees the width of the wedge: the
  // long block at the corner would fold in a wedge that bends more.
  double turn_per_angle = 1.5;
  // Part of the wedge's width that a point in its middle must be away from the boundary: in a wedge without holes it is
  // about half.
  double least_clearance = 0.25;
  // Steps along curved sides. Their lengths grow from the corner on, as the width of the wedge does: a step of length s
  // leaves the middle of sides of curvature k by k s^2 / 8.
  int num_steps = 64;
};
constexpr DivisionRules division_rules;

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
    for (int i = 1; i <= division_rules.num_steps; ++i) {
      const double here = distance_at(limit * i / division_rules.num_steps);
      if (here <= previous) return limit * (i - 1) / division_rules.num_steps;
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
  for (int i = 1; i <= division_rules.num_steps; ++i) {
    const double radius = reach * std::pow(static_cast<double>(i) / division_rules.num_steps, 2);
    const Vec2 a = in.at_distance(radius, end_in), b = out.at_distance(radius, end_out);
    line.points.push_back(0.5 * (a + b));
    line.widths.push_back(distance(a, b));
  }
}

Vec2 centre_of_division(const CadFace& face, const Corner& corner, const std::vector<CriticalPoint>& nodes) {
  const MiddleLine line = middle_line(face, corner.joint);
  double radius =
      std::min({division_rules.part_of_clearance * length_inside(face, line), division_rules.part_of_side * line.side,
                length_of_small_turn(line, division_rules.turn_per_angle)});
  for (const CriticalPoint& p : nodes)
    radius = std::min(radius, division_rules.part_of_distance * distance(p.position, corner.position));
  return point_at(line, radius);
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
  const curve::FaceBoundary boundary(face);
  const std::size_t last = line.points.size() - 1;
  const Vec2 direction = direction_of(line.points[last - 1], line.points[last]);
  if (last == 1) {
    const double off = tolerance::same_point * face.diameter;  // rays from the corner itself meet its sides
    return off + boundary.length_inside(line.points[0] + off * direction, direction);
  }
  double length = 0;
  for (std::size_t i = 1; i <= last; ++i) {
    if (boundary.signed_distance(line.points[i]) < division_rules.least_clearance * line.widths[i]) return length;
    length += distance(line.points[i - 1], line.points[i]);
  }
  return length + boundary.length_inside(line.points[last], direction);
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

void divide_degenerate_corners(const CadFace& face, CriticalPoints& points) {
  std::vector<placement::NodeEdit> edits;
  for (const Corner& corner : points.corners) {
    if (corner.valence != 0) continue;
    edits.push_back(
        {ChangeKind::divide,
         fmt::format("midpoint division: a corner of {:.6g} degrees at {} is too sharp for a block of four sides; a "
                     "node of valence 3 divides the block of three sides there into three of four",
                     corner.angle_degrees, surface::position_text(face, corner.position)),
         {{corner.joint, 1}},
         {{centre_of_division(face, corner, points.critical_points), 3}}});
  }
  placement::apply(edits, points);
}

void report_sharp_corners(const CadFace& face, const CriticalPoints& points, Report& report) {
  const Corner* sharpest = nullptr;
  int count = 0;
  for (const Corner& corner : points.corners) {
    if (corner.valence != 1 || corner.angle_degrees >= least_block_angle) continue;
    ++count;
    if (!sharpest || corner.angle_degrees < sharpest->angle_degrees) sharpest = &corner;
  }
  if (count == 0) return;
  report.warn(warning::sharp_corner,
              fmt::format("{} below {:.0f} degrees: that of {:.3g} degrees at {} limits the scaled Jacobian to {:.2g}",
                          count == 1 ? "one corner is" : fmt::format("{} corners are", count), least_block_angle,
                          sharpest->angle_degrees, surface::rounded_position_text(face, sharpest->position),
                          std::sin(radians(sharpest->angle_degrees))));
}

}  // namespace quadrille::guide
