#pragma once
// A quad mesh as OpenFOAM's blockMesh builds it: blocks of cells, seen from above (one cell thick, its sides straight).

#include <array>
#include <vector>

#include "export/block_grid.hpp"
#include "export/groups.hpp"

namespace quadrille::exports {

struct PlateBlock {
  std::array<int, 4> corners{};  ///< vertices, counter-clockwise
  int region = 0;
  std::array<DividedEdge, 4> edges;  ///< below, right, above, left, in the direction of rising i or j
};

struct PlateSpline {
  int from = 0, to = 0;     ///< vertices
  std::vector<Vec2> inner;  ///< between them
};

struct PlateBlocks {
  std::vector<int> vertices;  ///< mesh nodes
  std::vector<PlateBlock> blocks;
  std::vector<PlateSpline> splines;
  std::vector<std::vector<std::array<int, 2>>> patches;  ///< by boundary: sides of blocks, the domain on their left
  double moved = 0;  ///< largest distance of a cell's corner from its position by blockMesh, unit of the file
};

/// One hexahedral block for each block of the layout, cut in two, across all blocks that follow, wherever blockMesh
/// could not build it as it is: names that end within a side, two sides between the same vertices, corners that are not
/// convex, cells that blockMesh's own interpolation would fold or move by more than a tenth of their shortest side, a
/// corner on the other one of two periodic sides. Throws ComputeError with the position if a quad with straight sides
/// is not convex.
PlateBlocks plate_blocks(const QuadMesh& mesh, const Groups& groups);

}  // namespace quadrille::exports
