#pragma once
// The elements of each block as a grid of rows and columns, found from their common sides alone.

#include <optional>
#include <vector>

#include "export/skeleton.hpp"

namespace quadrille::exports {

struct BlockGrid {
  int block = 0;
  int num_i = 0, num_j = 0;         ///< elements in each direction, counter-clockwise from i to j
  std::vector<SkeletonEdge> cells;  ///< [num_j num_i], i fastest: each element by its lower side (lower j)

  const SkeletonEdge& cell(int i, int j) const { return cells[j * num_i + i]; }
  /// Sides of elements along a side of the grid, counter-clockwise: 0 at j = 0, 1 at i = num_i, 2 at j = num_j, 3 at
  /// i = 0.
  std::vector<SkeletonEdge> side(int k) const;
  /// Mesh nodes [(num_j + 1) (num_i + 1)], i fastest.
  std::vector<int> vertices(const QuadMesh& mesh) const;
};

/// One grid for each block; std::nullopt if the elements of a block form no grid with four corners (e.g. a ring).
std::optional<std::vector<BlockGrid>> block_grids(const QuadMesh& mesh);

/// The grids cut along whole lines through these mesh nodes, where they lie between the corners of a grid's side: from
/// one side of a grid to the other, then on through the neighbouring grids, so that the cut grids conform.
std::vector<BlockGrid> cut_grids(const QuadMesh& mesh, const std::vector<BlockGrid>& grids, std::vector<int> nodes);

}  // namespace quadrille::exports
