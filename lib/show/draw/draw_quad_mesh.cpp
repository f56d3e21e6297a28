// The quad mesh: elements coloured by scaled Jacobian, blocks outlined, the worst element ringed if it is poor, those
// that are not proved valid outlined in red.

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/symmetric_tensor.hpp"
#include "draw/draw_in_space.hpp"
#include "draw/figures.hpp"
#include "draw/labels.hpp"
#include "draw/marks.hpp"
#include "draw/palette.hpp"
#include "mesh/outer_faces.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::draw {

namespace {

Vec2 centre(const QuadMesh& mesh, int elem) {
  const int n = mesh.nodes_per_elem();
  Vec2 sum;
  for (int i = 0; i < n; ++i) sum += mesh.nodes[mesh.elem_nodes[elem * n + i]];
  return sum / n;
}

double ring_radius(const Picture& picture, const QuadMesh& mesh, int elem) {
  const Vec2 c = centre(mesh, elem);
  double radius = 0;
  for (int side = 0; side < 4; ++side)
    radius = std::max(radius, picture.scale() * distance(c, mesh.nodes[side_start(mesh, elem, side)]));
  return radius + 2;
}

bool is_unproved(const QuadMesh& mesh, int elem) {
  return !mesh.elem_jacobian_bound.empty() && !(mesh.elem_jacobian_bound[elem] > 0);
}

void draw_unproved(Picture& picture, const QuadMesh& mesh) {
  if (mesh.num_unproved() == 0) return;
  for (int e = 0; e < mesh.num_elems(); ++e)
    if (is_unproved(mesh, e))
      picture.add(
          path_element("worst", quad_outline(picture, mesh, e).str(),
                       fmt::format("quad {} is not proved valid: det J >= {:.3g}", e, mesh.elem_jacobian_bound[e])));
  picture.legend_mark(path_element("worst", "M-6 -6L6 -6L6 6L-6 6Z"),
                      fmt::format("not proved valid ({})", mesh.num_unproved()));
}

/// ", greatest edge ratio 8.1, greatest area jump 2.3, least node distance 0.04"; empty for files before version 1.3.
std::string sizes_text(const QuadMesh& mesh) {
  if (mesh.elem_edge_ratio.empty() || mesh.elem_area_jump.empty() || mesh.elem_node_distance.empty()) return "";
  const auto greatest = [](const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
  };
  return fmt::format(", greatest edge ratio {:.3g}, greatest area jump {:.3g}, least node distance {:.3g}",
                     greatest(mesh.elem_edge_ratio), greatest(mesh.elem_area_jump),
                     *std::min_element(mesh.elem_node_distance.begin(), mesh.elem_node_distance.end()));
}

std::string elem_text(const QuadMesh& mesh, int elem, double quality) {
  std::string text = fmt::format("quad {}, block {}, scaled Jacobian {:.3f}", elem, mesh.elem_block[elem], quality);
  if (!mesh.elem_edge_ratio.empty()) text += fmt::format(", edge ratio {:.3g}", mesh.elem_edge_ratio[elem]);
  return text;
}

std::string caption(const QuadMesh& mesh) {
  const auto& quality = mesh.elem_scaled_jacobian;
  const double worst = quality.empty() ? 0 : *std::min_element(quality.begin(), quality.end());
  return fmt::format("{}{} of order {} in {}{}, {}, worst scaled Jacobian {:.3f}{}",
                     mesh.is_valid ? "" : "NOT VALID: ", counted(mesh.num_elems(), "quad"), mesh.order,
                     counted(num_blocks(mesh), "block"), regions_text(mesh.face),
                     counted(mesh.num_irregular, "irregular node"), worst, sizes_text(mesh));
}

/// Short strokes along the longer of the lengths that a metric prescribes, where these differ.
void draw_prescribed_directions(Picture& picture, const QuadMesh& mesh) {
  constexpr double least_ratio = 1.2, most = 6, part = 0.3;  // of the lengths; pixels; of an element
  PathData path(1);
  for (std::size_t e = 0; e < mesh.elem_prescribed_stretch.size(); ++e) {
    const EigenPair of = eigen_pair(mesh.elem_prescribed_stretch[e]);
    if (of.first < least_ratio * of.second) continue;
    const Vec2 pixel = picture.at(centre(mesh, static_cast<int>(e)));
    const double half = std::min(most, part * ring_radius(picture, mesh, static_cast<int>(e)));
    path.move_to(pixel - half * left_of(unit(of.angle)));
    path.line_to(pixel + half * left_of(unit(of.angle)));
  }
  if (path.empty()) return;
  picture.add(path_element("prescribed", path.str()));
  picture.legend_mark(path_element("prescribed", "M-6 0L6 0"), "direction of the metric");
}

std::string draw_plane(const QuadMesh& mesh, const DrawOptions& options) {
  Picture picture(shown_box(bounding_box(mesh.face), mesh.face.origin, options), options, "Quad mesh", caption(mesh));
  picture.open_group("elems");
  for (int e = 0; e < mesh.num_elems(); ++e) {
    const double quality = mesh.elem_scaled_jacobian.empty() ? 1 : mesh.elem_scaled_jacobian[e];
    picture.add(svg_element("path",
                            {{"id", fmt::format("elem-{}", e)},
                             {"fill", ramp_colour(palette(Paper::light).quality, quality)},
                             {"d", quad_outline(picture, mesh, e).str()}},
                            elem_text(mesh, e, quality)));
  }
  picture.close_group();
  PathData borders;
  for (const auto& [at, other] : mesh::borders(mesh, mesh.elem_block)) {
    borders.move_to(picture.at(mesh.nodes[side_start(mesh, at.elem, at.side)]));
    append_curve(borders, quad_side(picture, mesh, at.elem, at.side), 0, 1);
  }
  if (!borders.empty()) picture.add(path_element("edge", borders.str()));
  draw_prescribed_directions(picture, mesh);
  draw_boundary(picture, mesh.face);
  const int worst = worst_to_mark(mesh.elem_scaled_jacobian);
  if (worst >= 0) {
    const Vec2 c = centre(mesh, worst);
    picture.add(circle_mark("ring", picture.at(c), ring_radius(picture, mesh, worst),
                            fmt::format("quad {} at {}: scaled Jacobian {:.3f}", worst,
                                        position_text(c, mesh.face.origin), mesh.elem_scaled_jacobian[worst])));
  }
  picture.legend_bar(palette(Paper::light).quality, "scaled Jacobian", {"0", "0.25", "0.5", "0.75", "1"});
  if (worst >= 0) picture.legend_mark(circle_mark("ring", {0, 0}, 7), "the worst");
  draw_unproved(picture, mesh);
  label_curves(picture, mesh.face, options.curve_labels);
  legend_scale(picture, mesh.face);
  return picture.str();
}

}  // namespace

std::string draw_stage(const QuadMesh& mesh, const DrawOptions& options) {
  if (options.view && mesh.space_nodes.empty())
    throw UsageError("--view is for meshes of curved faces, but this one is planar");
  if (options.view) return draw_in_space(mesh, space_view(mesh, *options.view), options, quad_title(mesh));
  if (mesh.space_nodes.empty() || options.window) return draw_plane(mesh, options);
  DrawOptions half = options;
  half.width = options.width / 2;
  return side_by_side({draw_plane(mesh, half), draw_in_space(mesh, space_view(mesh, {}), half, quad_title(mesh))},
                      "Quad mesh in the chart and in space", options.width);
}

}  // namespace quadrille::draw
