// Irregular nodes by valence with error bars, corners with their valences, and the origin of the nodes; over the field
// if it is known.

#include <fmt/format.h>

#include <algorithm>

#include "base/angle.hpp"
#include "draw/field_cells.hpp"
#include "draw/labels.hpp"
#include "draw/marks.hpp"
#include "draw/zero_contours.hpp"

namespace quadrille::draw {

namespace {

/// Pixels.
struct MarkRadii {
  double node = 10, ghost = 7, corner = 8, cluster = 17, ring = 14;
};
constexpr MarkRadii mark_radii{};

std::string cell_outline(const Picture& picture, const CertificateCell& cell) {
  const auto& v = cell.vertices;
  PathData path;
  path.move_to(picture.at({v[0], v[1]}));
  path.line_to(picture.at({v[2], v[3]}));
  path.line_to(picture.at({v[4], v[5]}));
  path.close();
  return path.str();
}

/// Position and size of `mark` in the picture.
struct Spot {
  Vec2 at;
  double radius = 0;
};

Spot spot(const Picture& picture, const NodeMark& mark, double inside_radius) {
  return {picture.at(mark.position), mark.location == NodeLocation::inside     ? inside_radius
                                     : mark.location == NodeLocation::boundary ? mark_radii.node
                                                                               : mark_radii.corner};
}

const Spot& nearest(const std::vector<Spot>& spots, Vec2 x) {
  return *std::min_element(spots.begin(), spots.end(),
                           [&](const Spot& a, const Spot& b) { return distance(a.at, x) < distance(b.at, x); });
}

bool is_at_one_of(const std::vector<Spot>& spots, Vec2 x) {
  return std::any_of(spots.begin(), spots.end(), [&](const Spot& s) { return distance(s.at, x) < 0.5; });
}

/// An arrow between two marks, or a ring about the second if they are too close for one.
std::string arrow_between(const Spot& from, const Spot& to) {
  const double gap = 2, shortest = 9;  // pixels
  const double length = distance(from.at, to.at) - from.radius - to.radius - 2 * gap;
  if (!(length >= shortest)) return circle_mark("change", to.at, std::max(mark_radii.ring, to.radius + 4));
  const Vec2 along = normalized(to.at - from.at);
  return arrow_mark(from.at + (from.radius + gap) * along, to.at - (to.radius + gap) * along);
}

std::vector<Spot> spots(const Picture& picture, const std::vector<NodeMark>& marks, double inside_radius) {
  std::vector<Spot> all;
  for (const NodeMark& mark : marks) all.push_back(spot(picture, mark, inside_radius));
  return all;
}

/// Draws an arrow from every mark before to the nearest one after, and to every remaining mark after. A mark that does
/// not move (a corner that absorbs a node) has no arrow.
std::string arrows(const std::vector<Spot>& before, const std::vector<Spot>& after) {
  std::string all;
  std::vector<Spot> reached;
  for (const Spot& from : before) {
    if (after.empty() || is_at_one_of(after, from.at)) continue;
    reached.push_back(nearest(after, from.at));
    all += arrow_between(from, reached.back());
  }
  for (const Spot& to : after) {
    if (is_at_one_of(reached, to.at) || is_at_one_of(before, to.at)) continue;
    all += before.empty() ? circle_mark("change", to.at, mark_radii.ring) : arrow_between(nearest(before, to.at), to);
  }
  return all;
}

std::string cross_mark(Vec2 at) {
  const double arm = 5;  // pixels
  PathData path;
  path.move_to(at + Vec2{-arm, -arm});
  path.line_to(at + Vec2{arm, arm});
  path.move_to(at + Vec2{-arm, arm});
  path.line_to(at + Vec2{arm, -arm});
  return path_element("change", path.str());
}

std::string change_marks(const Picture& picture, const NodeChange& change) {
  const std::vector<Spot> before = spots(picture, change.before, mark_radii.ghost);
  const std::vector<Spot> after = spots(picture, change.after, mark_radii.node);
  std::string all;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const bool was_node = change.before[i].location == NodeLocation::inside && !is_at_one_of(after, before[i].at);
    if (was_node) all += valence_outline(before[i].at, change.before[i].valence, mark_radii.ghost);
    if (after.empty()) all += cross_mark(before[i].at);
  }
  return all + arrows(before, after);
}

/// Cells in which the search for zeros ended, undecided ones in another colour, and the discs around corners that the
/// search omits; only those inside `face`, unless it is null.
void draw_certificate(Picture& picture, const Certificate& certificate, const CadFace* face) {
  bool has_open = false, has_zero = false;
  const std::size_t num_discs = std::min(certificate.disc_centres.size(), certificate.disc_radii.size());
  if (certificate.cells.empty() && num_discs == 0) return;
  if (face)
    picture.open_clipped_group("certificate", face_outline(picture, *face));
  else
    picture.open_group("certificate");
  for (const CertificateCell& cell : certificate.cells) {
    const bool is_open = cell.verdict == CellVerdict::open;
    (is_open ? has_open : has_zero) = true;
    picture.add(path_element(
        is_open ? "cell-open" : "cell-zero", cell_outline(picture, cell),
        fmt::format("cell in element {}: {}", cell.elem, is_open ? "could not be decided" : "holds exactly one zero")));
  }
  for (std::size_t i = 0; i < num_discs; ++i)
    picture.add(circle_mark("disc", picture.at(certificate.disc_centres[i]),
                            picture.scale() * certificate.disc_radii[i],
                            fmt::format("left to the corner: radius {:.3g}", certificate.disc_radii[i])));
  picture.close_group();
  if (has_zero) picture.legend_mark(path_element("cell-zero", "M-7 -5L7 -5L0 7z"), "cell with one zero");
  if (has_open) picture.legend_mark(path_element("cell-open", "M-7 -5L7 -5L0 7z"), "undecided cell");
  if (num_discs > 0) picture.legend_mark(circle_mark("disc", {0, 0}, 7), "left to the corner");
}

/// A dashed circle about each cluster, at least as large as a mark, with its index beside it. Hover: members, radius.
void draw_clusters(Picture& picture, const std::vector<Cluster>& clusters, Vec2 origin) {
  for (const Cluster& cluster : clusters) {
    const Vec2 at = picture.at(cluster.centre);
    const double radius = std::max(mark_radii.cluster, picture.scale() * cluster.radius);
    picture.add(circle_mark(
        "cluster", at, radius,
        fmt::format("cluster of index {} at {}, radius {:.3g}, {}", cluster.index,
                    position_text(cluster.centre, origin), cluster.radius, counted(cluster.members.size(), "member"))));
    for (const Vec2 member : cluster.members) picture.add(circle_mark("member", picture.at(member), 2));
    picture.text(at + (radius + 12) * normalized(Vec2{1, 1}), "label", fmt::format("{:+}", cluster.index));
  }
  if (!clusters.empty()) picture.legend_mark(circle_mark("cluster", {0, 0}, 7), "cluster and its index");
}

/// Draws each change: thin arrows from the nodes before to the nodes after, hollow marks at former positions, crosses
/// where nodes cancelled, a ring where both are too close for an arrow. Hover: kind and reason.
void draw_changes(Picture& picture, const std::vector<NodeChange>& changes) {
  bool has_ghost = false, has_cross = false;
  for (const NodeChange& change : changes) {
    picture.add(svg_element("g", {}, enum_name(change.kind) + ": " + change.reason, change_marks(picture, change)));
    for (const NodeMark& mark : change.before) has_ghost = has_ghost || mark.location == NodeLocation::inside;
    has_cross = has_cross || (change.after.empty() && !change.before.empty());
  }
  if (has_ghost) picture.legend_mark(valence_outline({0, 0}, 5, mark_radii.ghost), "node before a change");
  if (has_cross) picture.legend_mark(cross_mark({0, 0}), "cancelled");
  if (!changes.empty()) picture.legend_mark(arrow_mark({-8, 0}, {8, 0}), "change");
}

/// A triangle must be larger to fit its number.
double mark_radius(int valence) { return valence == 3 ? 1.3 * mark_radii.node : mark_radii.node; }

PictureBox box_of(const CriticalPoints& points) {
  PictureBox box;
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
  const auto count = [](const auto& list, const std::string& noun) { return counted(list.size(), noun); };
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
        at, node.valence, mark_radii.node,
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
  const double radius = picture.scale() * point.error;
  if (radius < 2) return false;  // pixels
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

std::string draw_stage(const CriticalPoints& points, const DrawOptions& options) {
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

}  // namespace quadrille::draw
