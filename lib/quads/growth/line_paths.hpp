#pragma once
// Lines of nodes that cross several blocks, from the boundary to the boundary.

#include <vector>

#include "mesh/block_sides.hpp"
#include "model/block_layout.hpp"

namespace quadrille::growth {

/// A line of nodes across one block: column (direction 0) or row (1) number `node`.
struct PieceId {
  int block = -1, direction = 0, node = 0;
  bool operator==(const PieceId&) const = default;
};

/// One end of a piece: 0 on side 0 or 3, 1 on side 2 or 1.
struct PieceEnd {
  PieceId piece;
  int end = 0;
};

struct LinePath {
  std::vector<PieceEnd> pieces;  ///< each with the end at which it is entered
  bool is_closed = false;        ///< the last piece is followed by the first
};

class LinePaths {
 public:
  /// `num_nodes`: by arc. Keeps a reference to the blocks.
  LinePaths(const BlockLayout& blocks, std::vector<int> num_nodes);
  /// The whole line that has this piece.
  LinePath through(const PieceId& start) const;

 private:
  PieceEnd beyond(const PieceEnd& at) const;

  const BlockLayout& blocks_;
  std::vector<int> num_nodes_;
  std::vector<int> curve_region_;
  mesh::ArcSides arc_sides_;
};

/// Whether a side runs against rising s (sides 0, 2) or t (1, 3) of its block.
bool is_reversed_side(const BlockLayout& blocks, int block, int side);

}  // namespace quadrille::growth
