// Irregular nodes by valence with error bars, corners with their valences, and the origin of the nodes; over the field
// if it is known.

#include <fmt/format.h>

#include "base/angle.hpp"
#include "draw/curve_labels.hpp"
#include "draw/field_cells.hpp"
#include "draw/instantiate_picture.hpp"
#include "draw/marks.hpp"
#include "draw/node_history.hpp"

namespace quadrille::draw {

namespace {

constexpr double node_radius = 10;  // pixels

/// A triangle must be larger to fit its number.
double mark_radius(int valence) { return valence == 3 ? 1.3 * node_radius : node_radius; }

PictureBox box_of(const CriticalPoints& points) {
  PictureBox box = empty_box();
  for (const CriticalPoint& p : points.critical_points) box.include(p.position);
  for (const CriticalPoint& p : points.zeros) box.include(p.position);
  for (const Corner& c : points.corners) box.include(c.position);
  for (const IrregularBoundaryPoint& b : points.boundary_nodes) box.include(b.position);
  for (std::size_t i = 0; i < points.certificate.disc_radii.size(); ++i)
    for (const double r : {-points.certificate.disc_radii[i], points.certificate.disc_radii[i]})
      box.include(points.certificate.disc_centres[i] + Vec2{r, r});
  if (box.empty() || box.lower != box.upper) return box;
  return {box.lower - Vec2{1, 1}, box.upper + Vec2{1, 1}};  // one point: a margin around it
}

void draw_quiet_field(Picture& picture, const Field& field) {
  const RegionFields regions(field);
  draw_face_area(picture, field.mesh.face);
  picture.open_group("quiet");
  for (const field::FieldEvaluator& evaluator : regions.evaluators) draw_crosses(picture, evaluator, 26);
  picture.close_group();
  if (field.kind != FieldKind::phase) draw_zero_contours(picture, regions);  // a unit field has no zeros
  draw_boundary(picture, field.mesh.face);
}

void draw_outline(Picture& picture, const CadFace& face) {
  draw_face_area(picture, face);
  draw_boundary(picture, face);
}

/// The direction of the label of a corner: out of the face, opposite to the bisector of its interior angle; into its
/// region where neighbours meet in the corner, so that each has its own; without a face, away from the centre of the
/// picture.
Vec2 label_direction(const Picture& picture, const CadFace* face, const Corner& corner) {
  if (face && corner.joint >= 0 && corner.joint < static_cast<int>(face->joints.size())) {
    const Joint& joint = face->joints[corner.joint];
    const Vec2 inwards = unit(joint.tangent_out + joint.interior_angle / 2);
    return face->is_slit_joint(corner.joint) ? inwards : -inwards;
  }
  const Vec2 from_middle = picture.at(corner.position) - 0.5 * picture.size();
  return norm(from_middle) > 1 ? normalized(from_middle) : Vec2{0, 1};
}

std::string caption(const CriticalPoints& points) {
  const auto count = [](const auto& list, const std::string& noun) {
    return counted(static_cast<int>(list.size()), noun);
  };
  const bool is_phase = points.form == NodeForm::phase;
  std::string text = fmt::format("{}, {}", count(points.critical_points, is_phase ? "node" : "critical point"),
                                 count(points.corners, "corner"));
  if (!points.boundary_nodes.empty()) text += ", " + count(points.boundary_nodes, "boundary node");
  text += fmt::format(", index sum {} (expected {})", points.index_sum, points.index_sum_expected);
  if (!points.changes.empty()) text += ", " + count(points.changes, "change");
  if (points.certificate.cells_examined > 0)
    text += fmt::format(", {} cells searched", points.certificate.cells_examined);
  return text + regions_text(points.face);
}

/// Text such as ", source: cluster" for a node that was neither found as a zero nor measured; else empty.
std::string source_text(NodeSource source, NodeSource ordinary) {
  return source == ordinary ? "" : ", source: " + enum_name(source);
}

void draw_corner_valences(Picture& picture, const CriticalPoints& points, const CadFace* face) {
  bool has_taker = false;
  for (const Corner& corner : points.corners) {
    const Vec2 at = picture.at(corner.position);
    const bool is_taker = corner.source == NodeSource::absorb;
    has_taker = has_taker || is_taker;
    if (is_taker) picture.add(circle_mark("taker", at, 8));
    picture.add(circle_mark(
        "corner", at, 4.5,
        fmt::format("corner at {}, {:.4g} degrees, valence {}{}{}", position_text(corner.position, points.origin),
                    corner.angle_degrees, corner.valence, corner.valence == 0 ? ", degenerate" : "",
                    source_text(corner.source, NodeSource::angle))));
    picture.text(at + 17 * label_direction(picture, face, corner), "label", std::to_string(corner.valence));
  }
  if (!points.corners.empty()) picture.legend_mark(circle_mark("corner", {0, 0}, 4.5), "corner and its valence");
  if (has_taker)
    picture.legend_mark(circle_mark("taker", {0, 0}, 8) + circle_mark("corner", {0, 0}, 4.5),
                        "corner that absorbed a node");
}

void draw_boundary_nodes(Picture& picture, const CriticalPoints& points) {
  for (const IrregularBoundaryPoint& node : points.boundary_nodes) {
    const Vec2 at = picture.at(node.position);
    picture.add(boundary_mark(
        at, node.valence, node_radius,
        fmt::format("boundary node of valence {} at {}{}", node.valence, position_text(node.position, points.origin),
                    source_text(node.source, NodeSource::hand))));
    picture.text(at, "inner", std::to_string(node.valence));
  }
  if (!points.boundary_nodes.empty())
    picture.legend_mark(boundary_mark({0, 0}, points.boundary_nodes.front().valence, 8), "node on the boundary");
}

/// Draws the error bar as a circle if it is large enough to be visible; others appear in the hover text only. Returns
/// whether it was drawn.
bool draw_error_bar(Picture& picture, const CriticalPoint& point) {
  constexpr double smallest = 2;  // pixels
  const double radius = picture.scale() * point.error;
  if (radius < smallest) return false;
  picture.add(circle_mark("error", picture.at(point.position), radius,
                          fmt::format("error bar of the position: {:.3g}", point.error)));
  return true;
}

void draw_nodes(Picture& picture, const CriticalPoints& points) {
  std::vector<int> valences;
  bool has_error_bar = false;
  for (const CriticalPoint& p : points.critical_points) {
    valences.push_back(p.valence);
    const Vec2 at = picture.at(p.position);
    const std::string error = p.error > 0 ? fmt::format(" ± {:.2g}", p.error) : "";
    picture.add(valence_mark(
        at, p.valence, mark_radius(p.valence),
        fmt::format("{} of valence {} at {}{}{}", p.source == NodeSource::zero ? "critical point" : "irregular node",
                    p.valence, position_text(p.position, points.origin), error,
                    source_text(p.source, NodeSource::zero))));
    picture.text(at, "inner", std::to_string(p.valence));
    has_error_bar = draw_error_bar(picture, p) || has_error_bar;
  }
  legend_valences(picture, valences);
  if (has_error_bar) picture.legend_mark(circle_mark("error", {0, 0}, 7), "error bar");
}

}  // namespace

std::string picture_of(const CriticalPoints& points, const DrawOptions& options) {
  const Field* field = options.field;
  const CadFace* face = field ? &field->mesh.face : points.face.curves.empty() ? nullptr : &points.face;
  const bool is_phase = points.form == NodeForm::phase;
  Picture picture(shown_box(face ? bounding_box(*face) : box_of(points), points.origin, options), options,
                  is_phase ? "Irregular nodes and corners (phase form)" : "Critical points and corners",
                  caption(points));
  if (field)
    draw_quiet_field(picture, *field);
  else if (face)
    draw_outline(picture, *face);
  draw_certificate(picture, points.certificate, face);
  draw_clusters(picture, points.clusters, points.origin);
  draw_changes(picture, points.changes);
  draw_corner_valences(picture, points, face);
  draw_boundary_nodes(picture, points);
  draw_nodes(picture, points);
  if (face) label_curves(picture, *face, options.curve_labels);
  face ? legend_scale(picture, *face) : picture.legend_scale("");
  return picture.str();
}

template std::string draw_stage(const CriticalPoints&, const DrawOptions&);

}  // namespace quadrille::draw
