#include "guide/divide_corners.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/position_text.hpp"
#include "base/warning_codes.hpp"
#include "guide/admissible_valence.hpp"
#include "guide/middle_line.hpp"
#include "placement/node_ledger.hpp"

namespace quadrille::guide {
namespace {

// Greatest distance of the node of a division from its corner.
struct DivisionRules {
  double part_of_clearance = 0.25;  // of the length of the middle line inside the face
  double part_of_side = 0.5;        // of the shorter side
  double part_of_distance = 0.5;    // of the distance to any other node
  // The middle line turns by at most this multiple of the angle under which the corner sees the width of the wedge: the
  // long block at the corner would fold in a wedge that bends more.
  double turn_per_angle = 1.5;
};

constexpr DivisionRules division_rules;

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

void divide_degenerate_corners(const CadFace& face, CriticalPoints& points) {
  std::vector<placement::NodeEdit> edits;
  for (const Corner& corner : points.corners) {
    if (corner.valence != 0) continue;
    edits.push_back(
        {ChangeKind::divide,
         fmt::format("midpoint division: a corner of {:.6g} degrees at {} is too sharp for a block of four sides; a "
                     "node of valence 3 divides the block of three sides there into three of four",
                     corner.angle_degrees, position_text(corner.position + face.origin)),
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
                          sharpest->angle_degrees, rounded_position_text(sharpest->position + face.origin),
                          std::sin(radians(sharpest->angle_degrees))));
}

}  // namespace quadrille::guide
