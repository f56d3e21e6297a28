#include "draw/marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/angle.hpp"
#include "base/message_text.hpp"
#include "curve/nurbs.hpp"
#include "model/length_scale.hpp"
#include "model/quad_mesh.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::draw {

namespace {

PathData closed_loop(const Picture& picture, const CadFace& face, int loop) {
  PathData path;
  for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c)
    append_nurbs(path, picture, face.curves[c], face.curves[c].begin(), face.curves[c].end());
  path.close();
  return path;
}

/// A regular polygon with a vertex at the top.
std::string polygon_mark(const std::string& css_class, Vec2 centre, int num_vertices, double radius,
                         const std::string& title) {
  std::string points;
  for (int k = 0; k < num_vertices; ++k) {
    const Vec2 p = centre + radius * unit(half_pi + 2 * pi * k / num_vertices);
    points += fmt::format("{}{},{}", k > 0 ? " " : "", svg_number(p.x), svg_number(p.y));
  }
  return svg_element("polygon", {{"class", css_class}, {"points", points}}, title);
}

std::string valence_figure(const std::string& css_class, Vec2 centre, int valence, double radius,
                           const std::string& title) {
  const bool is_polygon = valence >= 3 && valence <= 8;
  return is_polygon ? polygon_mark(css_class, centre, valence, radius, title)
                    : circle_mark(css_class, centre, 0.8 * radius, title);
}

bool is_slit(const CadFace& face, int curve) {
  return face.is_interface(curve) &&
         face.region_of_loop(face.loop_of(curve)) == face.region_of_loop(face.loop_of(face.partners[curve]));
}

/// The text "boundary curve 4: hole", "interface, curves 1 and 7: fluid-solid".
std::string curve_title(const CadFace& face, int curve) {
  const std::string name = curve < static_cast<int>(face.curve_names.size()) ? face.curve_names[curve] : "";
  const std::string suffix = name.empty() ? "" : ": " + name;
  if (!face.is_interface(curve)) return fmt::format("boundary curve {}{}", curve, suffix);
  return fmt::format("{}, curves {} and {}{}", is_slit(face, curve) ? "slit" : "interface", curve, face.partners[curve],
                     suffix);
}

std::string curve_markup(const Picture& picture, const CadFace& face, int curve, const char* css_class) {
  PathData path;
  append_nurbs(path, picture, face.curves[curve], face.curves[curve].begin(), face.curves[curve].end());
  Attributes attributes{{"d", path.str()}};
  if (css_class) attributes.insert(attributes.begin(), {"class", css_class});
  return svg_element("path", attributes, curve_title(face, curve));
}

/// Below the boundary, which ends of interfaces must not cover.
void draw_interfaces(Picture& picture, const CadFace& face) {
  for (int c = 0; c < face.num_curves(); ++c)
    if (face.is_interface(c) && c < face.partners[c])
      picture.add(curve_markup(picture, face, c, is_slit(face, c) ? "slit" : "interface"));
}

}  // namespace

void append_nurbs(PathData& path, const Picture& picture, const Nurbs& curve, double t0, double t1) {
  const bool forwards = t0 <= t1;
  std::vector<double> cuts{std::min(t0, t1)};
  for (const double knot : curve.knots)
    if (knot > cuts.back() && knot < std::max(t0, t1)) cuts.push_back(knot);
  cuts.push_back(std::max(t0, t1));
  if (!forwards) std::reverse(cuts.begin(), cuts.end());
  if (path.empty()) path.move_to(picture.at(curve::point(curve, t0)));
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const double last = std::max(cuts[i - 1], cuts[i]);
    const PixelCurve pixels = [&](double t) -> CurvePoint {
      const auto d = curve::derivatives(curve, t, t == last);
      return {picture.at(d[0]), picture.scale() * d[1]};
    };
    append_curve(path, pixels, cuts[i - 1], cuts[i]);
  }
}

std::vector<ArcPiece> side_pieces(const BlockLayout& layout, HalfEdge side) {
  std::vector<ArcPiece> pieces = layout.arcs[side.arc].pieces;
  if (!side.is_backwards) return pieces;
  std::reverse(pieces.begin(), pieces.end());
  for (ArcPiece& piece : pieces) std::swap(piece.t0, piece.t1);
  return pieces;
}

std::string face_outline(const Picture& picture, const CadFace& face) {
  std::string d;
  for (int l = 0; l < face.num_loops(); ++l) d += closed_loop(picture, face, l).str();
  return d;
}

std::vector<int> region_tints(const CadFace& face) {
  std::map<std::string, int> tints;
  std::vector<int> region2tint;
  for (const std::string& name : face.region_names)
    region2tint.push_back(tints.try_emplace(name, static_cast<int>(tints.size())).first->second);
  return region2tint;
}

void draw_face_area(Picture& picture, const CadFace& face) {
  if (face.num_regions() == 1) return picture.add(path_element("face", face_outline(picture, face)));
  const std::vector<int> tints = region_tints(face);
  for (int r = 0; r < face.num_regions(); ++r) {
    std::string d;
    for (int l = face.region_loops[r]; l < face.region_loops[r + 1]; ++l) d += closed_loop(picture, face, l).str();
    picture.add(svg_element("path", {{"class", "face"}, {"style", "fill:" + region_colour(tints[r])}, {"d", d}},
                            face.region_names[r]));
  }
}

void legend_regions(Picture& picture, const CadFace& face) {
  constexpr int max_listed = 12;
  if (face.num_regions() == 1) return;
  const std::vector<int> tints = region_tints(face);
  int num_named = 0;
  for (int r = 0; r < face.num_regions(); ++r) {
    if (tints[r] < num_named) continue;
    if (num_named++ >= max_listed) continue;
    picture.legend_mark(
        svg_element("path", {{"fill", region_colour(tints[r])}, {"stroke", "#44535f"}, {"d", "M-6,-5H6V5H-6Z"}}),
        face.region_names[r]);
  }
  if (num_named > max_listed)
    picture.legend_mark("", fmt::format("and {}", counted(num_named - max_listed, "more region")));
}

void draw_boundary(Picture& picture, const CadFace& face) {
  draw_interfaces(picture, face);
  picture.open_group("boundary");
  for (int c = 0; c < face.num_curves(); ++c)
    if (!face.is_interface(c)) picture.add(curve_markup(picture, face, c, nullptr));
  picture.close_group();
}

void draw_corners(Picture& picture, const CadFace& face) {
  for (std::size_t j = 0; j < face.joints.size(); ++j) {
    const Joint& joint = face.joints[j];
    if (!joint.is_corner) continue;
    picture.add(circle_mark("corner", picture.at(joint.position), 4,
                            fmt::format("corner at {}, {:.4g} degrees", position_text(joint.position, face.origin),
                                        degrees(joint.interior_angle))));
  }
}

void legend_corner(Picture& picture, const CadFace& face) {
  const auto is_corner = [](const Joint& joint) { return joint.is_corner; };
  if (std::any_of(face.joints.begin(), face.joints.end(), is_corner))
    picture.legend_mark(circle_mark("corner", {0, 0}, 4), "corner");
}

std::string regions_text(const CadFace& face) {
  return face.num_regions() > 1 ? ", " + counted(face.num_regions(), "region") : "";
}

void legend_scale(Picture& picture, const CadFace& face) {
  bool has_slit = false, has_interface = false;
  for (int c = 0; c < face.num_curves(); ++c)
    if (face.is_interface(c)) (is_slit(face, c) ? has_slit : has_interface) = true;
  const auto add = [&](const char* css_class, const char* label) {
    picture.legend_mark(path_element(css_class, "M-9 0L9 0"), label);
  };
  if (has_interface) add("interface", "interface of two regions");
  if (has_slit) add("slit", "slit");
  picture.legend_scale(unit_symbol(face) + (face.chart ? " in the chart" : ""));
}

std::string square_mark(const std::string& fill) {
  return svg_element("rect", {{"x", "-7"},
                              {"y", "-7"},
                              {"width", "14"},
                              {"height", "14"},
                              {"rx", "2"},
                              {"fill", fill},
                              {"stroke", "#5b6f82"},
                              {"stroke-width", ".6"}});
}

std::string circle_mark(const std::string& css_class, Vec2 centre, double radius, const std::string& title) {
  return svg_element(
      "circle",
      {{"class", css_class}, {"cx", svg_number(centre.x)}, {"cy", svg_number(centre.y)}, {"r", svg_number(radius)}},
      title);
}

std::string valence_mark(Vec2 centre, int valence, double radius, const std::string& title) {
  return valence_figure(valence == 3 ? "v3" : valence == 5 ? "v5" : "vx", centre, valence, radius, title);
}

std::string valence_outline(Vec2 centre, int valence, double radius, const std::string& title) {
  return valence_figure("ghost", centre, valence, radius, title);
}

std::string boundary_mark(Vec2 centre, int valence, double radius, const std::string& title) {
  return polygon_mark(valence == 1 ? "v3" : valence == 3 ? "v5" : "vx", centre, 4, radius, title);
}

std::string arrow_mark(Vec2 from, Vec2 to) {
  const double head_length = 7, head_width = 2.6;  // pixels
  const Vec2 along = normalized(to - from), across = head_width * left_of(along);
  const Vec2 neck = to - head_length * along;
  PathData shaft, head;
  shaft.move_to(from);
  shaft.line_to(neck);
  head.move_to(to);
  head.line_to(neck + across);
  head.line_to(neck - across);
  head.close();
  return path_element("change", shaft.str()) + path_element("head", head.str());
}

void legend_valences(Picture& picture, std::vector<int> valences) {
  std::sort(valences.begin(), valences.end());
  valences.erase(std::unique(valences.begin(), valences.end()), valences.end());
  for (const int v : valences)
    picture.legend_mark(valence_mark({0, 0}, v, 7), fmt::format("irregular node, valence {}", v));
}

int worst_to_mark(const std::vector<double>& scaled_jacobians) {
  const auto worst = std::min_element(scaled_jacobians.begin(), scaled_jacobians.end());
  return worst != scaled_jacobians.end() && *worst < 0.5 ? static_cast<int>(worst - scaled_jacobians.begin()) : -1;
}

std::string position_text(Vec2 x, Vec2 origin) { return position_text(x + origin); }

PathData tri_outline(const Picture& picture, const spectral::TriMap& map) {
  PathData path;
  path.move_to(picture.at(map.position(spectral::tri_edge_point(0, 0))));
  for (int edge = 0; edge < 3; ++edge) {
    const Vec2 along = spectral::tri_edge_point(edge, 1) - spectral::tri_edge_point(edge, 0);
    const PixelCurve pixels = [&](double s) -> CurvePoint {
      Vec2 x;
      Mat2 dx_dxi;
      map.evaluate(spectral::tri_edge_point(edge, s), x, dx_dxi);
      return {picture.at(x), picture.scale() * (dx_dxi * along)};
    };
    if (map.is_affine() && edge == 2) break;  // closing the path draws it
    append_curve(path, pixels, 0, 1);
  }
  path.close();
  return path;
}

PixelCurve quad_side(const Picture& picture, const QuadMesh& mesh, int elem, int side) {
  const std::vector<double>& points = spectral::gll_points(mesh.order);
  const Eigen::Index m = mesh.order + 1;
  Eigen::MatrixXd positions(m, 2);
  for (int i = 0; i < m; ++i) {
    const Vec2 x = picture.at(mesh.nodes[side_node(mesh, elem, side, i)]);
    positions.row(i) << x.x, x.y;
  }
  const Eigen::MatrixXd derivatives = spectral::differentiation_matrix(points) * positions;
  return [&points, positions, derivatives](double s) -> CurvePoint {
    const Eigen::MatrixXd row = spectral::interpolation_matrix(points, {2 * s - 1});
    const Eigen::RowVector2d x = row * positions, d = 2.0 * row * derivatives;
    return {{x(0), x(1)}, {d(0), d(1)}};
  };
}

PathData quad_outline(const Picture& picture, const QuadMesh& mesh, int elem) {
  PathData path;
  path.move_to(picture.at(mesh.nodes[side_start(mesh, elem, 0)]));
  for (int side = 0; side < 4; ++side) append_curve(path, quad_side(picture, mesh, elem, side), 0, 1);
  path.close();
  return path;
}

}  // namespace quadrille::draw
