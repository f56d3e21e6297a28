// Hexahedra: a tab in space alone, with the measures of all elements.

#include <fmt/format.h>

#include "base/message_text.hpp"
#include "page/sheet.hpp"
#include "page/space_data.hpp"

namespace quadrille::page {

namespace {

JsonObject solids_layer(const HexMesh& mesh) {
  std::vector<std::int32_t> quad_regions;
  for (const int block : mesh.quad_block) quad_regions.push_back(mesh.block_region[block]);
  JsonObject layer;
  layer.text("type", "solids").text("key", "mesh").text("title", "hexahedra").text("noun", "hexahedron");
  layer.flag("shown", true);
  layer.json("quantities", quantities_json({{"scaled Jacobian", "low", 0, 1, mesh.elem_scaled_jacobian},
                                            bounds_of_jacobian(mesh.elem_jacobian_bound)}));
  layer.data("regions", packed(quad_regions)).json("regionNames", json_texts(mesh.region_names));
  return layer;
}

}  // namespace

Sheet stage_sheet(const HexMesh& mesh, const PageFrame&) {
  Sheet sheet;
  sheet.title = "Hexahedra";
  sheet.is_only_in_space = true;
  sheet.caption = fmt::format("{}{} hexahedra of order {} in {}", mesh.is_valid ? "" : "NOT VALID: ", mesh.num_elems(),
                              mesh.order, counted(mesh.num_layers(), "layer"));
  sheet.facts = draw::figures_of(mesh);
  sheet.layers.push_back(solids_layer(mesh));
  sheet.space = space_data(mesh).str();
  return sheet;
}

}  // namespace quadrille::page
