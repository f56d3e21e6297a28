#pragma once
// The elements of each block as a grid of rows and columns, found from their common sides alone.
//
// An edge of a hexahedral block as OpenFOAM's blockMesh divides it: points of a spline, parametrized by the length of
// the polygon through them, and the fraction of that length for each cell.

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

struct DividedEdge {
  std::vector<Vec2> vertices;     ///< ends of the cells, one more than there are cells
  std::vector<double> fractions;  ///< length fraction of each cell; the sum is 1
  std::vector<Vec2> inner;        ///< points of the spline between the ends, the inner vertices among them
  bool is_straight = false;       ///< within 1e-10 of its length: no spline is needed

  int num_cells() const { return static_cast<int>(fractions.size()); }
  /// By vertex: the sum of the fractions before it, added up as blockMesh does.
  std::vector<double> weights() const;
  DividedEdge reversed() const;
};

/// The edge along consecutive sides of elements.
DividedEdge divided_edge(const QuadMesh& mesh, const std::vector<SkeletonEdge>& sides);

/// The points that blockMesh computes in a block whose edges in i direction at j = 0 and j = num_j are `bottom` and
/// `top`, those in j direction at i = 0 and i = num_i `left` and `right`; i fastest. Each is a mean of points on the
/// straight edges plus a mean deviation of the splines from them, with separate weights. Source: OpenFOAM,
/// block::createPoints, in the plane.
std::vector<Vec2> block_mesh_points(const DividedEdge& bottom, const DividedEdge& right, const DividedEdge& top,
                                    const DividedEdge& left);

}  // namespace quadrille::exports
