#pragma once
// A mesh as structured solvers know it: rectangular grids of points, the boundaries along their sides, and the sides
// that are common to two grids.
//
// An element of order N is N^2 cells between its nodes. Points of a grid count from 0: i along side 0, j along side 3.
// Along a side they count counter-clockwise, from its first corner: side 0 is j = 0 with rising i, 1 is i = num_i with
// rising j, 2 is j = num_j with falling i, 3 is i = 0 with falling j.

#include <array>
#include <vector>

#include "export/block_grid.hpp"
#include "export/groups.hpp"
#include "model/hex_mesh.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// A part of a side of a grid, between two of its points.
struct SideRange {
  int grid = 0, side = 0;
  int begin = 0, end = 0;
};

struct BoundaryRange {
  SideRange range;
  int boundary = 0;  ///< Groups::boundary_names
};

/// Two ranges of the same points: the first point of the one is the last of the other.
struct GridConnection {
  SideRange first, second;
  int interface = -1;  ///< number after the boundaries, as Groups::curve2boundary; -1: none
};

struct MultiBlock {
  QuadMesh quads;  ///< the cells, of order 1; of hexahedra those of a layer, without positions
  std::vector<BlockGrid> grids;
  std::vector<BoundaryRange> boundaries;    ///< grid by grid, side by side, counter-clockwise
  std::vector<GridConnection> connections;  ///< each once, sorted by the first range

  // Of hexahedra:
  int num_levels = 1;                    ///< of points
  std::vector<int> columns;              ///< [node of quads, level]: the mesh node
  std::vector<std::array<int, 2>> ends;  ///< by grid: the boundary of the first and of the last level; -1: they are one

  /// The mesh nodes of a grid, i fastest, then j.
  std::vector<int> points(const BlockGrid& grid) const;

  /// Numbers of points (i, j), from 0.
  std::array<int, 2> point(const SideRange& range, int at) const;
};

/// One grid for each block; where a block is no rectangular grid, the grids of merge_blocks. A side that has several
/// boundaries or neighbours has several ranges. Throws ComputeError with the position if a cell is not convex.
MultiBlock multi_block(const QuadMesh& mesh, const Groups& groups);

/// A swept mesh as structured solvers know it: the grids of its quads, times the layers. Everything about sides follows
/// from the quads of one layer (layer_quads.hpp); the third index runs with the sweep, so that a grid is right-handed.
/// `cells`: hexahedra of order 1 (split_at_nodes of a mesh). Throws ComputeError if a side, the bottom or the top of a
/// grid has two names.
MultiBlock multi_block(const HexMesh& cells, const Groups& groups);

}  // namespace quadrille::exports
