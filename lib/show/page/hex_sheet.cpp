// Hexahedra: their outer faces as quads, in space and in the projection that the pane in space begins with.

#include <fmt/format.h>

#include "draw/draw_in_space.hpp"
#include "mesh/outer_faces.hpp"
#include "page/sheet.hpp"

namespace quadrille::page {

namespace {

QuadMesh projected_faces(const HexMesh& mesh) {
  QuadMesh outer = mesh::outer_faces(mesh);
  const draw::SpaceView view = draw::space_view(outer, {});
  for (std::size_t i = 0; i < outer.nodes.size(); ++i) outer.nodes[i] = view.at(outer.space_nodes[i]);
  return outer;
}

}  // namespace

draw::PictureBox hex_box(const HexMesh& mesh) {
  draw::PictureBox box;
  for (const Vec2 x : projected_faces(mesh).nodes) box.include(x);
  return box;
}

Sheet stage_sheet(const HexMesh& mesh, const PageFrame& frame) {
  Sheet sheet = stage_sheet(projected_faces(mesh), frame);
  sheet.title = "Hexahedra";
  sheet.is_only_in_space = true;
  sheet.caption = fmt::format("{}{} hexahedra of order {} in {} layers; their outer faces",
                              mesh.is_valid ? "" : "NOT VALID: ", mesh.num_elems(), mesh.order, mesh.num_layers());
  sheet.facts = draw::figures_of(mesh);
  return sheet;
}

}  // namespace quadrille::page
