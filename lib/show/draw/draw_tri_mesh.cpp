// Draws the triangle mesh: curved edges, corner fans tinted by layer, corners.

#include <fmt/format.h>

#include <algorithm>

#include "draw/labels.hpp"
#include "draw/marks.hpp"
#include "mesh/tri_topology.hpp"

namespace quadrille::draw {

namespace {

const Ramp& layer_ramp() {
  static const Ramp ramp{{0, "#d9703f"}, {1, "#fbe9d2"}};
  return ramp;
}

}  // namespace

std::string draw_stage(const TriMesh& mesh, const DrawOptions& options) {
  const int num_curved = static_cast<int>(mesh.curved_elems.size());
  Picture picture(
      shown_box(bounding_box(mesh.face), mesh.face.origin, options), options, "Triangle mesh",
      fmt::format("{}, {} of them curved (order {}), {} boundary edges{}", counted(mesh.num_elems(), "triangle"),
                  num_curved, mesh.order, mesh.boundary_edges.size(), regions_text(mesh.face)));
  const int last_layer =
      mesh.elem_layer.empty() ? -1 : *std::max_element(mesh.elem_layer.begin(), mesh.elem_layer.end());
  const std::vector<spectral::TriMap> maps = mesh::tri_maps(mesh);
  picture.open_group("elems");
  for (int e = 0; e < mesh.num_elems(); ++e) {
    const int layer = mesh.elem_layer.empty() ? -1 : mesh.elem_layer[e];
    const std::string fill = layer < 0 ? (maps[e].is_affine() ? "#f1f4f6" : "#d7e6ef")
                                       : ramp_colour(layer_ramp(), (layer + 0.5) / (last_layer + 1));
    picture.add(svg_element(
        "path", {{"id", fmt::format("elem-{}", e)}, {"fill", fill}, {"d", tri_outline(picture, maps[e]).str()}},
        fmt::format("triangle {}{}", e, layer < 0 ? "" : fmt::format(", layer {} of a corner fan", layer))));
  }
  picture.close_group();
  draw_boundary(picture, mesh.face);
  draw_corners(picture, mesh.face);
  picture.legend_mark(square_mark("#f1f4f6"), "straight");
  if (num_curved > 0) picture.legend_mark(square_mark("#d7e6ef"), "curved");
  if (last_layer >= 0) picture.legend_mark(square_mark(ramp_colour(layer_ramp(), 0.3)), "corner fan");
  legend_corner(picture, mesh.face);
  label_curves(picture, mesh.face, options.curve_labels);
  legend_scale(picture, mesh.face);
  return picture.str();
}

}  // namespace quadrille::draw
