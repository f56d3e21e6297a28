#include "export/multi_block.hpp"

#include <array>
#include <map>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "export/layer_quads.hpp"
#include "export/merge_blocks.hpp"
#include "export/split_elements.hpp"
#include "export/vertex_stars.hpp"

namespace quadrille::exports {

namespace {

/// What lies beyond a cell's side: a boundary, or a place on the side of a grid.
struct Beyond {
  int line = -1;  ///< boundary or interface
  int grid = -1, side = 0, position = 0;
};

class RangeFinder {
 public:
  RangeFinder(const Groups& groups, MultiBlock& blocks) : blocks_(blocks), stars_(blocks.quads) {
    for (int g = 0; g < static_cast<int>(blocks.grids.size()); ++g)
      for (int side = 0; side < 4; ++side) {
        int position = 0;
        for (const SkeletonEdge& e : blocks.grids[g].side(side)) places_[{e.elem, e.side}] = {-1, g, side, position++};
      }
    for (const auto* edges : {&blocks.quads.boundary_edges, &blocks.quads.interface_edges})
      for (const QuadBoundaryEdge& e : *edges) lines_[{e.elem, e.side}] = groups.curve2boundary[e.curve];
  }

  void find() {
    for (int g = 0; g < static_cast<int>(blocks_.grids.size()); ++g)
      for (int side = 0; side < 4; ++side) add_side(g, side);
  }

 private:
  Beyond beyond(const SkeletonEdge& e) const {
    const auto line = lines_.find({e.elem, e.side});
    const int across = stars_.across(e.elem, e.side);
    Beyond result = across < 0 ? Beyond{} : places_.at({across / 4, across % 4});
    if (line != lines_.end()) result.line = line->second;
    return result;
  }

  static bool continues(const Beyond& a, const Beyond& b) {
    return a.line == b.line && a.grid == b.grid && a.side == b.side && (a.grid < 0 || b.position == a.position - 1);
  }

  void add_side(int grid, int side) {
    const std::vector<SkeletonEdge> edges = blocks_.grids[grid].side(side);
    std::vector<Beyond> all;
    for (const SkeletonEdge& e : edges) all.push_back(beyond(e));
    const int count = static_cast<int>(all.size());
    for (int begin = 0, end = 0; begin < count; begin = end) {
      end = begin + 1;
      while (end < count && continues(all[end - 1], all[end])) ++end;
      add_range({grid, side, begin, end}, all[begin], all[end - 1]);
    }
  }

  void add_range(const SideRange& range, const Beyond& first, const Beyond& last) {
    if (first.grid < 0) {
      blocks_.boundaries.push_back({range, first.line});
      return;
    }
    const SideRange other{first.grid, first.side, last.position, first.position + 1};
    const auto key = [](const SideRange& r) { return std::array{r.grid, r.side, r.begin}; };
    if (key(range) < key(other)) blocks_.connections.push_back({range, other, first.line});
  }

  MultiBlock& blocks_;
  VertexStars stars_;
  std::map<std::pair<int, int>, Beyond> places_;  ///< by element and side
  std::map<std::pair<int, int>, int> lines_;
};

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

/// Of quads of order 1, whose positions do not matter.
MultiBlock multi_block_of_cells(QuadMesh quads, const Groups& groups) {
  MultiBlock blocks;
  blocks.quads = std::move(quads);
  std::optional<std::vector<BlockGrid>> grids = block_grids(blocks.quads);
  if (!grids) {
    blocks.quads = merge_blocks(std::move(blocks.quads));
    grids = block_grids(blocks.quads);
  }
  blocks.grids = std::move(grids.value());
  RangeFinder(groups, blocks).find();
  return blocks;
}

}  // namespace

std::array<int, 2> MultiBlock::point(const SideRange& range, int at) const {
  const BlockGrid& grid = grids[range.grid];
  switch (range.side) {
    case 0:
      return {at, 0};
    case 1:
      return {grid.num_i, at};
    case 2:
      return {grid.num_i - at, grid.num_j};
    default:
      return {0, grid.num_j - at};
  }
}

std::vector<int> MultiBlock::points(const BlockGrid& grid) const {
  std::vector<int> nodes = grid.vertices(quads);
  if (columns.empty()) return nodes;
  std::vector<int> all;
  for (int level = 0; level < num_levels; ++level)
    for (const int node : nodes) all.push_back(columns[static_cast<std::size_t>(node) * num_levels + level]);
  return all;
}

MultiBlock multi_block(const QuadMesh& mesh, const Groups& groups) {
  QuadMesh quads = split_at_nodes(mesh);
  require_valid_pieces(quads, "Cells");
  return multi_block_of_cells(std::move(quads), groups);
}

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
