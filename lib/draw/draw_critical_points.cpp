// Critical points by valence and corners with their valences, over the field where it is given.

#include <fmt/format.h>

#include "base/angle.hpp"
#include "draw/field_cells.hpp"
#include "draw/marks.hpp"

namespace quadrille {

namespace {

Box box_of(const CriticalPoints& points) {
  Box box = empty_box();
  for (const CriticalPoint& p : points.critical_points) box.include(p.position);
  for (const Corner& c : points.corners) box.include(c.position);
  return box;
}

void draw_quiet_field(Picture& picture, const Field& field) {
  const FieldEvaluator evaluator(field);
  draw_face_area(picture, field.mesh.face);
  picture.open_group("quiet");
  draw_crosses(picture, evaluator, 26);
  picture.close_group();
  draw_zero_contours(picture, evaluator);
  draw_boundary(picture, field.mesh.face);
}

/// A direction out of the face at a corner: opposite to the bisector of its interior angle.
Vec2 outwards(const CadFace& face, const Corner& corner) {
  if (corner.joint < 0 || corner.joint >= static_cast<int>(face.joints.size())) return {0, 1};
  const Joint& joint = face.joints[corner.joint];
  return -unit(joint.tangent_out + joint.interior_angle / 2);
}

}  // namespace

std::string draw_critical_points(const CriticalPoints& points, const Field* field, const DrawOptions& options) {
  const Box box = field ? bounding_box(field->mesh.face) : box_of(points);
  Picture picture(box, options, "Critical points and corners",
                  fmt::format("{}, {}, index sum {} (expected {})",
                              counted(static_cast<int>(points.critical_points.size()), "critical point"),
                              counted(static_cast<int>(points.corners.size()), "corner"), points.index_sum,
                              points.index_sum_expected));
  if (field) draw_quiet_field(picture, *field);
  for (const Corner& corner : points.corners) {
    const Vec2 at = picture.at(corner.position);
    picture.add(
        circle_mark("corner", at, 4.5,
                    fmt::format("corner at {}, {:.4g} degrees, valence {}", place_text(corner.position, points.origin),
                                corner.angle_degrees, corner.valence)));
    picture.text(at + 15 * (field ? outwards(field->mesh.face, corner) : Vec2{0, 1}), "label",
                 std::to_string(corner.valence));
  }
  std::vector<int> valences;
  for (const CriticalPoint& p : points.critical_points) {
    valences.push_back(p.valence);
    picture.add(valence_mark(
        picture.at(p.position), p.valence, 10,
        fmt::format("critical point of valence {} at {}", p.valence, place_text(p.position, points.origin))));
  }
  legend_valences(picture, valences);
  if (!points.corners.empty()) picture.legend_mark(circle_mark("corner", {0, 0}, 4.5), "corner and its valence");
  return picture.str();
}

}  // namespace quadrille
