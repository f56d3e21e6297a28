#include "export/hex_grids.hpp"

#include <array>
#include <utility>

#include "base/error.hpp"
#include "export/layer_quads.hpp"

namespace quadrille::exports {

namespace {

/// By node of quads_of_layer: the mesh nodes above it, level by level.
std::vector<int> columns_of(const HexMesh& cells, const QuadMesh& quads) {
  const int num_levels = cells.num_layers() + 1;
  std::vector<int> columns(quads.nodes.size() * num_levels);
  for (int elem = 0; elem < cells.num_elems(); ++elem)
    for (int local = 0; local < 8; ++local) {
      const int node = quads.elem_nodes[4 * (elem % cells.num_quads) + local % 4];
      const int level = elem / cells.num_quads + local / 4;
      columns[static_cast<std::size_t>(node) * num_levels + level] =
          cells.elem_nodes[8 * static_cast<std::size_t>(elem) + local];
    }
  return columns;
}

/// By quad: the boundary of its bottom and of its top, -1 for none.
std::vector<std::array<int, 2>> boundaries_of_ends(const HexMesh& cells, const Groups& groups) {
  std::vector<std::array<int, 2>> ends(cells.num_quads, {-1, -1});
  for (std::size_t g = 0; g < cells.face_groups.size(); ++g)
    for (std::size_t k = 0; k < cells.face_groups[g].elems.size(); ++k)
      if (const int face = cells.face_groups[g].faces[k]; face >= 4)
        ends[cells.face_groups[g].elems[k] % cells.num_quads][face - 4] = groups.curve2boundary[g];
  return ends;
}

}  // namespace

MultiBlock multi_block(const HexMesh& cells, const Groups& groups) {
  QuadMesh quads = quads_of_layer(cells);
  std::vector<int> columns = columns_of(cells, quads);
  MultiBlock blocks = multi_block_of_cells(std::move(quads), groups);
  blocks.num_levels = cells.num_layers() + 1;
  blocks.columns = std::move(columns);
  const std::vector<std::array<int, 2>> ends = boundaries_of_ends(cells, groups);
  for (const BlockGrid& grid : blocks.grids) {
    blocks.ends.push_back(ends[grid.cells.front().elem]);
    for (const SkeletonEdge& cell : grid.cells)
      if (ends[cell.elem] != blocks.ends.back())
        throw ComputeError("the end of a grid has two names: grids need one name for the bottom and one for the top");
  }
  return blocks;
}

}  // namespace quadrille::exports
