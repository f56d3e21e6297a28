// The guiding field: u, v or the cross angle as smooth colour with zero contours, or the order map.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "draw/field_cells.hpp"
#include "draw/labels.hpp"
#include "draw/marks.hpp"
#include "draw/palette.hpp"
#include "draw/zero_contours.hpp"
#include "mesh/tri_topology.hpp"

namespace quadrille::draw {

namespace {

/// Number of colours: small, so that cells share paths, and large enough for smooth pictures.
double stepped(double value, double steps) { return std::round(value * steps) / steps; }

bool is_phase(const Field& field) { return field.kind == FieldKind::phase; }

std::string title(const Field& field, const std::string& show) {
  const std::string what = show == "psi"     ? "cross angle ψ"
                           : show == "order" ? "order of each element"
                                             : "component " + show;
  return (is_phase(field) ? "Phase form: " : "Guiding field: ") + what;
}

/// One for each region.
std::vector<const PhaseForm*> phases_of(const Field& field) {
  std::vector<const PhaseForm*> phases;
  if (is_phase(field) && field.region_phases.empty()) phases.push_back(&field.phase);
  for (const PhaseForm& phase : field.region_phases) phases.push_back(&phase);
  return phases;
}

/// The text "4 nodes asked for, 8 corner valences".
std::string asked_text(const std::vector<const PhaseForm*>& phases) {
  int num_nodes = 0, num_boundary_nodes = 0, num_corners = 0;
  for (const PhaseForm* phase : phases) {
    num_nodes += static_cast<int>(phase->prescribed.nodes.size());
    num_boundary_nodes += static_cast<int>(phase->prescribed.boundary_nodes.size());
    num_corners += static_cast<int>(phase->prescribed.corners.size());
  }
  std::string text = counted(num_nodes, "node") + " asked for";
  if (num_boundary_nodes > 0) text += ", " + counted(num_boundary_nodes, "boundary node");
  if (num_corners > 0) text += ", " + counted(num_corners, "corner valence");
  return text;
}

std::string caption(const Field& field) {
  const auto [least, greatest] = std::minmax_element(field.elem_order.begin(), field.elem_order.end());
  if (field.elem_order.empty()) return "no elements";
  const std::string orders =
      *least == *greatest ? fmt::format("order {}", *least) : fmt::format("orders {} to {}", *least, *greatest);
  const std::string coefficients = is_phase(field) ? fmt::format("{} coefficients", field.coef_offsets.back())
                                                   : fmt::format("{} coefficients per component", field.u.size());
  std::string text = fmt::format("{}, {}, {}", counted(field.mesh.num_elems(), "triangle"), orders, coefficients);
  if (!field.liftings.empty()) text += ", " + counted(field.liftings.size(), "lifting");
  if (is_phase(field)) text += ", " + asked_text(phases_of(field));
  return text + regions_text(field.mesh.face);
}

void draw_cross_angle(Picture& picture, const RegionFields& regions) {
  const auto colour = [](Vec2 value) {
    return cross_angle_colour(Paper::light, stepped(degrees(cross_angle(value)), 1),
                              stepped(std::min(1.0, norm(value)), 24));
  };
  const auto difference = [](Vec2 a, Vec2 b) {
    const double turn = std::abs(degrees(wrap_pi(angle_of(a) - angle_of(b)))) / 4;
    return std::max(turn * std::min(1.0, norm(a) * 4) / 2, std::abs(norm(a) - norm(b)) * 12);
  };
  for (const field::FieldEvaluator& evaluator : regions.evaluators)
    draw_field_cells(picture, evaluator, colour, difference);
  for (const field::FieldEvaluator& evaluator : regions.evaluators) draw_crosses(picture, evaluator, 34);
  picture.legend_bar(cross_angle_ramp(Paper::light), "cross angle ψ in degrees", {"−45", "−22.5", "0", "22.5", "45"});
}

void draw_component(Picture& picture, const RegionFields& regions, bool is_u) {
  const auto component = [is_u](Vec2 value) { return is_u ? value.x : value.y; };
  for (const field::FieldEvaluator& evaluator : regions.evaluators)
    draw_field_cells(
        picture, evaluator,
        [&](Vec2 value) { return ramp_colour(component_ramp(), stepped(0.5 * (component(value) + 1), 96)); },
        [&](Vec2 a, Vec2 b) { return std::abs(component(a) - component(b)) * 28; });
  picture.legend_bar(component_ramp(), is_u ? "u" : "v", {"−1", "−0.5", "0", "0.5", "1"});
}

void draw_orders(Picture& picture, const Field& field) {
  const std::vector<spectral::TriMap> maps = mesh::tri_maps(field.mesh);
  const std::set<int> orders(field.elem_order.begin(), field.elem_order.end());
  const auto fill = [&](int order) {
    const double range = *orders.rbegin() - *orders.begin();
    return ramp_colour(palette(Paper::light).amount, range > 0 ? (order - *orders.begin()) / range : 0.4);
  };
  picture.open_group("elems");
  for (int e = 0; e < field.mesh.num_elems(); ++e) {
    const int order = field.elem_order[e];
    picture.add(svg_element(
        "path", {{"id", fmt::format("elem-{}", e)}, {"fill", fill(order)}, {"d", tri_outline(picture, maps[e]).str()}},
        fmt::format("triangle {}, order {}", e, order)));
    const double area = std::abs(det([&] {
      Vec2 x;
      Mat2 dx_dxi;
      maps[e].evaluate({-1.0 / 3, -1.0 / 3}, x, dx_dxi);
      return dx_dxi;
    }()));
    if (std::sqrt(2 * area) * picture.scale() > 26)
      picture.text(picture.at(maps[e].position({-1.0 / 3, -1.0 / 3})), "small", std::to_string(order));
  }
  picture.close_group();
  for (const int order : orders) picture.legend_mark(square_mark(fill(order)), fmt::format("{}", order));
}

/// The nodes prescribed for the phases of all regions.
void draw_nodes_asked(Picture& picture, const std::vector<Field>& regions) {
  std::vector<int> valences, boundary_valences;
  for (const Field& field : regions) {
    for (const PhaseNode& node : field.phase.prescribed.nodes) {
      valences.push_back(node.valence);
      picture.add(valence_mark(picture.at(node.position), node.valence, 9,
                               fmt::format("node of valence {} asked for at {}", node.valence,
                                           position_text(node.position, field.mesh.face.origin))));
    }
    for (const BoundaryNode& node : field.phase.prescribed.boundary_nodes) {
      boundary_valences.push_back(node.valence);
      const Nurbs& curve = field.mesh.face.curves[node.curve];
      picture.add(
          boundary_mark(picture.at(curve::point(curve, node.t)), node.valence, 9,
                        fmt::format("boundary node of valence {} asked for on curve {}", node.valence, node.curve)));
    }
  }
  legend_valences(picture, valences);
  if (!boundary_valences.empty())
    picture.legend_mark(boundary_mark({0, 0}, boundary_valences.front(), 8), "node on the boundary");
}

/// Short strokes in the directions that the field was aligned with: of the strongest terms, one in each square of
/// pixels.
void draw_prescribed_directions(Picture& picture, const Field& field, const RegionFields& regions) {
  constexpr double spacing = 16, half = 6, least_rate = 0.1;  // pixels; of the greatest rate
  if (field.alignment.empty()) return;
  std::vector<AlignmentPoint> points = field.alignment;
  std::ranges::stable_sort(points, std::greater(), &AlignmentPoint::rate);
  std::set<std::pair<int, int>> taken;
  PathData path(1);
  for (const AlignmentPoint& point : points) {
    const Vec2 pixel = picture.at(point.position), along = half * unit(point.angle);
    Vec2 value;
    const bool is_inside = std::ranges::any_of(
        regions.evaluators, [&](const auto& evaluator) { return evaluator.value_at(point.position, value); });
    if (!is_inside || !picture.holds(pixel) || point.rate < least_rate * points.front().rate) continue;
    if (!taken.emplace(static_cast<int>(pixel.x / spacing), static_cast<int>(pixel.y / spacing)).second) continue;
    path.move_to(pixel - along);
    path.line_to(pixel + along);
  }
  if (path.empty()) return;
  picture.add(path_element("prescribed", path.str()));
  picture.legend_mark(path_element("prescribed", "M-6 0L6 0"), "prescribed direction");
}

}  // namespace

std::string draw_stage(const Field& field, const DrawOptions& options) {
  Picture picture(shown_box(bounding_box(field.mesh.face), field.mesh.face.origin, options), options,
                  title(field, options.show), caption(field));
  const RegionFields regions(field);
  if (options.show == "order") {
    draw_orders(picture, field);
  } else if (options.show == "psi" || options.show == "u" || options.show == "v") {
    options.show == "psi" ? draw_cross_angle(picture, regions) : draw_component(picture, regions, options.show == "u");
    if (!is_phase(field)) draw_zero_contours(picture, regions);  // the contours of a unit field do not intersect
  } else {
    throw UsageError("--show: '" + options.show + "' is not one of psi|u|v|order");
  }
  draw_prescribed_directions(picture, field, regions);
  draw_boundary(picture, field.mesh.face);
  draw_corners(picture, field.mesh.face);
  if (is_phase(field)) draw_nodes_asked(picture, regions.fields);
  label_curves(picture, field.mesh.face, options.curve_labels);
  legend_scale(picture, field.mesh.face);
  return picture.str();
}

}  // namespace quadrille::draw
