#include <fmt/format.h>

#include <iterator>

#include "export/gmsh.hpp"
#include "export/gmsh_model.hpp"

namespace quadrille::exports {
namespace {

std::string nodes_section(const GmshModel& model) {
  std::string text = fmt::format("$Nodes\n{}\n", model.positions.size());
  for (const auto& entities : model.entity_nodes)
    for (const auto& nodes : entities)
      for (const int node : nodes) {
        fmt::format_to(std::back_inserter(text), "{} ", model.node_tags[node]);
        append_position(model.positions[node], text);
        text += '\n';
      }
  text += "$EndNodes\n";
  return text;
}

/// "tag type 2 physical elementary nodes": in this version each element lists its groups itself.
std::string elements_section(const GmshModel& model, const QuadMesh& mesh) {
  std::string text = fmt::format(
      "$Elements\n{}\n", mesh.boundary_edges.size() + interface_edges_once(mesh).size() + mesh.elem_block.size());
  int tag = 0;
  const auto begin = [&](int type, int group, std::size_t entity) {
    fmt::format_to(std::back_inserter(text), "{} {} 2 {} {}", ++tag, type, group, entity + 1);
  };
  for (std::size_t c = 0; c < model.skeleton.curves.size(); ++c) {
    const SkeletonCurve& curve = model.skeleton.curves[c];
    if (curve.cad_curve < 0) continue;
    for (const SkeletonEdge& e : curve.edges) {
      begin(model.line_type, model.boundary_group(curve.cad_curve), c);
      append_gmsh_line(model, mesh, e, text);
    }
  }
  for (std::size_t block = 0; block < model.block_elems.size(); ++block)
    for (const int elem : model.block_elems[block]) {
      begin(model.quad_type, model.region_group(static_cast<int>(block)), block);
      append_gmsh_quad(model, mesh, elem, text);
    }
  text += "$EndElements\n";
  return text;
}

}  // namespace

Exported gmsh_msh22(const QuadMesh& mesh, const Frame& frame) {
  const GmshModel model = gmsh_model(mesh, frame);
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + gmsh_names(model.groups);
  text += nodes_section(model);
  text += elements_section(model, mesh);
  text += gmsh_periodic(model, mesh, frame, "Affine");
  return {std::move(text), false, {}, {}};
}

}  // namespace quadrille::exports
