#pragma once
// The intervals of the lines of nodes inside blocks, from wall to wall: the arcs beside a line determine how they grow,
// and a correction along the whole line (growth/line_correction) makes them fill every block that it crosses. Adjacent
// lines are then tied to each other (layers/layered_block); where this exceeds the limit, a second correction follows,
// from the intervals that the mesh has.

#include <cstddef>
#include <vector>

#include "layers/wall_layers.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::growth {

/// The vertices of one block of a mesh.
class BlockVertices {
 public:
  /// `first`: the block's first element.
  BlockVertices(const QuadMesh& mesh, std::size_t first, int columns, int rows)
      : mesh_(mesh), first_(first), columns_(columns), rows_(rows) {}

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  /// Vertex k of column (direction 0) or row (1) `node`, a number of nodes.
  Vec2 at(int direction, int node, int k) const {
    return direction == 0 ? position(node, k * mesh_.order) : position(k * mesh_.order, node);
  }

 private:
  Vec2 position(int i, int j) const;  ///< node number i along side 0, j along side 1

  const QuadMesh& mesh_;
  std::size_t first_;
  int columns_, rows_;
};

/// By block of a mesh, which must outlive them.
std::vector<BlockVertices> block_vertices(const BlockLayout& blocks, const sizing::ArcDivisions& divisions,
                                          const QuadMesh& mesh);

/// By block: LayeredBlock::lines, or its factors.
using BlockLines = std::vector<layers::BlockLineLengths>;

struct LinePlan {
  BlockLines lengths;                     ///< of the intervals of all lines, before they are tied to each other
  BlockLines factors;                     ///< of the intervals that are tied to each other; empty: none
  std::vector<layers::RowShifts> shifts;  ///< by block: LayeredBlock::shifts; empty: none
};

/// The lengths for all lines of the nodes of elements of this order; `limit`: greatest ratio of adjacent intervals that
/// is aimed at. Cost: linear in the nodes, with some evaluations of each block's map for every line.
BlockLines line_intervals(const sizing::MeasuredLayout& measured, const layers::WallPlan& walls,
                          const sizing::ArcDivisions& divisions, double limit, int order);

/// Multiplies the factors of all lines that have lengths so that the intervals of `mesh`, which was made with `lines`,
/// exceed the limit less. Cost: linear in the nodes.
void correct_factors(const sizing::MeasuredLayout& measured, const layers::WallPlan& walls,
                     const sizing::ArcDivisions& divisions, const QuadMesh& mesh, double limit, LinePlan& lines);

}  // namespace quadrille::growth
