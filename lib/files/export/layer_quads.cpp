#include "export/layer_quads.hpp"

#include <fmt/format.h>

#include <vector>

#include "base/error.hpp"

namespace quadrille::exports {

namespace {

/// By quad of a layer and side: the group of faces there, -1 for none.
std::vector<int> groups_of_sides(const HexMesh& mesh) {
  std::vector<int> side2group(4 * static_cast<std::size_t>(mesh.num_quads), -1);
  const auto each_side = [&](const auto& visit) {
    for (std::size_t g = 0; g < mesh.face_groups.size(); ++g)
      for (std::size_t k = 0; k < mesh.face_groups[g].elems.size(); ++k)
        if (const int face = mesh.face_groups[g].faces[k]; face < 4)
          visit(static_cast<int>(g), mesh.face_groups[g].elems[k], face);
  };
  each_side([&](int group, int elem, int face) {
    if (elem < mesh.num_quads) side2group[4 * elem + face] = group;
  });
  each_side([&](int group, int elem, int face) {
    if (side2group[4 * (elem % mesh.num_quads) + face] != group)
      throw ComputeError(
          fmt::format("face {} of hexahedron {} is called {}, and another layer has no such side there: "
                      "grids need sides of one name from bottom to top",
                      face, elem, mesh.face_groups[group].name));
  });
  return side2group;
}

/// Quads without numbers of nodes yet.
QuadMesh named_quads(const HexMesh& mesh) {
  QuadMesh quads;
  quads.order = mesh.order;
  quads.elem_block = mesh.quad_block;
  for (const int region : mesh.block_region) quads.block_names.push_back(mesh.region_names[region]);
  for (const HexFaceGroup& group : mesh.face_groups) quads.face.curve_names.push_back(group.name);
  quads.face.curves.resize(mesh.face_groups.size());
  const std::vector<int> side2group = groups_of_sides(mesh);
  for (int k = 0; k < static_cast<int>(side2group.size()); ++k)
    if (const int group = side2group[k]; group >= 0)
      (mesh.face_groups[group].is_interface ? quads.interface_edges : quads.boundary_edges)
          .push_back({k / 4, k % 4, group});
  return quads;
}

}  // namespace

QuadMesh quads_of_layer(const HexMesh& mesh) {
  QuadMesh quads = named_quads(mesh);
  std::vector<int> numbers(mesh.nodes.size(), -1);
  const int size = quads.nodes_per_elem();
  for (int quad = 0; quad < mesh.num_quads; ++quad)
    for (int local = 0; local < size; ++local) {
      int& number = numbers[mesh.elem_nodes[quad * mesh.nodes_per_elem() + local]];
      if (number < 0) {
        number = static_cast<int>(quads.nodes.size());
        quads.nodes.emplace_back();
      }
      quads.elem_nodes.push_back(number);
    }
  return quads;
}

}  // namespace quadrille::exports
