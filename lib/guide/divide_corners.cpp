#include "guide/divide_corners.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/angle.hpp"
#include "base/position_text.hpp"
#include "curve/nurbs.hpp"
#include "guide/admissible_valence.hpp"
#include "guide/node_ring.hpp"
#include "placement/clearance.hpp"

namespace quadrille::guide {
namespace {

constexpr double part_of_clearance = 0.25, part_of_side = 0.5;

/// The distance between the ends of a side; for a closed side, from its end to its middle.
double side_length(const CadFace& face, int curve, bool is_outgoing) {
  const Nurbs& c = face.curves[curve];
  return distance(c.poles.front(), c.poles.back()) > 0 ? distance(c.poles.front(), c.poles.back())
                                                       : distance(curve::point(c, is_outgoing ? c.begin() : c.end()),
                                                                  curve::point(c, 0.5 * (c.begin() + c.end())));
}

Vec2 centre_of_division(const CadFace& face, const Corner& corner, const std::vector<CriticalPoint>& nodes) {
  const Joint& joint = face.joints[corner.joint];
  const Vec2 bisector = unit(joint.tangent_out + joint.interior_angle / 2);
  const double off = 1e-6 * face.diameter;  // away from the corner itself
  const double sides = std::min(side_length(face, corner.curves[0], false), side_length(face, corner.curves[1], true));
  double radius =
      std::min(part_of_clearance * placement::clearance_along(face, joint.position + off * bisector, bisector),
               part_of_side * sides);
  for (const CriticalPoint& p : nodes) radius = std::min(radius, 0.5 * distance(p.position, joint.position));
  return joint.position + radius * bisector;
}

}  // namespace

void divide_degenerate_corners(const CadFace& face, CriticalPoints& points) {
  const std::vector<CriticalPoint> others = points.critical_points;
  for (Corner& corner : points.corners) {
    if (corner.valence != 0 || !is_admissible_valence(corner.angle_degrees, 1)) continue;
    if (points.form == NodeForm::harmonic && points.zeros.empty()) points.zeros = others;
    const CriticalPoint node = made_node(centre_of_division(face, corner, others), 1, NodeSource::divide);
    points.changes.push_back(
        {ChangeKind::divide,
         fmt::format("midpoint division: a corner of {:.6g} degrees at {} is too sharp for a block of four sides; a "
                     "node of valence 3 divides the block of three sides there into three of four",
                     corner.angle_degrees, position_text(corner.position + face.origin)),
         {{corner.position, 0, NodeLocation::corner}},
         {{corner.position, 1, NodeLocation::corner}, {node.position, node.valence, NodeLocation::inside}}});
    points.critical_points.push_back(node);
    corner.valence = 1;
    corner.source = NodeSource::divide;
    points.form = NodeForm::phase;
  }
}

}  // namespace quadrille::guide
