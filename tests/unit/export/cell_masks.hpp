#pragma once
// Meshes of unit squares, each a block of its own, drawn by characters.

#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// A square wherever a row, from above, has '#'; a letter makes a block of that name. All boundary edges are of curve
/// 0, "side".
inline QuadMesh mesh_of_mask(const std::vector<std::string>& rows) {
  QuadMesh mesh;
  mesh.order = 1;
  mesh.face.curves.resize(1);
  mesh.face.curve_names = {"side"};
  mesh.face.diameter = static_cast<double>(rows.size());
  std::map<std::pair<int, int>, int> node, cell;
  const auto node_at = [&](int i, int j) {
    const auto [entry, is_new] = node.try_emplace({i, j}, static_cast<int>(mesh.nodes.size()));
    if (is_new) mesh.nodes.push_back({1.0 * i, 1.0 * j});
    return entry->second;
  };
  const int height = static_cast<int>(rows.size());
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < static_cast<int>(rows[height - 1 - j].size()); ++i) {
      const char mark = rows[height - 1 - j][i];
      if (mark == '.') continue;
      cell[{i, j}] = mesh.num_elems();
      for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}})
        mesh.elem_nodes.push_back(node_at(i + a, j + b));
      if (mark == '#') mesh.unnamed_blocks.push_back(mesh.num_elems());
      mesh.block_names.emplace_back(mark == '#' ? "block_" + std::to_string(mesh.num_elems()) : std::string(1, mark));
      mesh.elem_block.push_back(mesh.num_elems());
    }
  for (const auto& [at, elem] : cell)
    for (int side = 0; side < 4; ++side) {
      const int di = side == 1 ? 1 : side == 3 ? -1 : 0, dj = side == 2 ? 1 : side == 0 ? -1 : 0;
      if (cell.count({at.first + di, at.second + dj}) == 0) mesh.boundary_edges.push_back({elem, side, 0});
    }
  return mesh;
}

/// A ring of n by m cells between the radii 1 and 2, each a block of its own; inside curve 1 "hole", outside curve 0
/// "side".
inline QuadMesh ring_of_cells(int n, int m) {
  QuadMesh mesh;
  mesh.order = 1;
  mesh.face.curves.resize(2);
  mesh.face.curve_names = {"side", "hole"};
  mesh.face.diameter = 4;
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i < n; ++i) mesh.nodes.push_back((2 - 1.0 * j / m) * unit(2 * std::numbers::pi * i / n));
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}})
        mesh.elem_nodes.push_back((j + b) * n + (i + a) % n);
      const int elem = mesh.num_elems();
      mesh.unnamed_blocks.push_back(elem);
      mesh.block_names.push_back("block_" + std::to_string(elem));
      mesh.elem_block.push_back(elem);
      if (j == 0) mesh.boundary_edges.push_back({elem, 0, 0});
      if (j == m - 1) mesh.boundary_edges.push_back({elem, 2, 1});
    }
  return mesh;
}

}  // namespace quadrille::exports
