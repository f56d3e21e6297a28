#include "growth/line_paths.hpp"

#include <utility>

#include "model/interfaces.hpp"

namespace quadrille::growth {
namespace {

int side_of(int direction, int end) { return direction == 0 ? 2 * end : 3 - 2 * end; }

}  // namespace

bool is_reversed_side(const BlockLayout& blocks, int block, int side) {
  return blocks.block2arcs[block][side].is_backwards != (side >= 2);
}

LinePaths::LinePaths(const BlockLayout& blocks, std::vector<int> num_nodes)
    : blocks_(blocks),
      num_nodes_(std::move(num_nodes)),
      curve_region_(curve_regions(blocks.face)),
      arc_sides_(mesh::sides_of_arcs(blocks)) {}

/// The end of the piece that continues beyond an end of a piece; block -1: none does.
PieceEnd LinePaths::beyond(const PieceEnd& at) const {
  const int side = side_of(at.piece.direction, at.end), arc = blocks_.block2arcs[at.piece.block][side].arc;
  const std::vector<mesh::BlockSide>& sides = arc_sides_[arc];
  if (sides.size() != 2 || separates_faces(blocks_, blocks_.arcs[arc], curve_region_)) return {};
  const bool is_first = sides[0].block == at.piece.block && sides[0].side == side;
  const mesh::BlockSide& other = sides[is_first ? 1 : 0];
  const bool turns =
      is_reversed_side(blocks_, at.piece.block, side) != is_reversed_side(blocks_, other.block, other.side);
  return {{other.block, other.side % 2, turns ? num_nodes_[arc] - 1 - at.piece.node : at.piece.node},
          other.side == 0 || other.side == 3 ? 0 : 1};
}

LinePath LinePaths::through(const PieceId& start) const {
  PieceEnd first{start, 0};
  LinePath line;
  for (PieceEnd before = beyond(first); before.piece.block >= 0; before = beyond(first)) {
    first = {before.piece, 1 - before.end};
    if ((line.is_closed = first.piece == start)) break;
  }
  line.pieces.push_back(first);
  for (;;) {
    const PieceEnd next = beyond({line.pieces.back().piece, 1 - line.pieces.back().end});
    if (next.piece.block < 0 || (line.is_closed && next.piece == start)) return line;
    line.pieces.push_back(next);
  }
}

}  // namespace quadrille::growth
