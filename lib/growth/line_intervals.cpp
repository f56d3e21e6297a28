#include "growth/line_intervals.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "growth/limit_growth.hpp"
#include "growth/line_correction.hpp"
#include "mesh/block_sides.hpp"
#include "model/interfaces.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::growth {
namespace {

/// A line of nodes across one block: column (direction 0) or row (1) number `node`.
struct PieceId {
  int block = -1, direction = 0, node = 0;
};

/// One end of a piece: 0 on side 0 or 3, 1 on side 2 or 1.
struct PieceEnd {
  PieceId piece;
  int end = 0;
};

int side_of(int direction, int end) { return direction == 0 ? 2 * end : 3 - 2 * end; }

class Lines {
 public:
  Lines(const sizing::MeasuredLayout& measured, const layers::WallPlan& walls, const sizing::ArcDivisions& divisions,
        double limit, int order)
      : blocks_(measured.blocks()),
        limit_(std::pow(limit, 1 - growth_constants.margin)),
        curve_region_(curve_regions(blocks_.face)),
        arc_sides_(mesh::sides_of_arcs(blocks_)) {
    for (std::size_t arc = 0; arc < divisions.size(); ++arc)
      nodes_.push_back(walls.arc_nodes[arc].empty() ? all_nodes(divisions[arc].ends, order) : walls.arc_nodes[arc]);
    for (int block = 0; block < blocks_.num_blocks(); ++block) {
      const layers::LayeredBlock layered = layers::layered_block(walls, measured, block, side_fractions(block));
      for (const int direction : {0, 1})
        pieces_[direction].push_back(layers::block_lines(layered, direction, order, blocks_.face.origin));
      result_.emplace_back();
      for (const int direction : {0, 1}) result_.back()[direction].resize(pieces_[direction].back().size());
    }
  }

  BlockLines corrected() {
    for (int block = 0; block < blocks_.num_blocks(); ++block)
      for (const int direction : {0, 1})
        for (int node = 1; node + 1 < static_cast<int>(pieces_[direction][block].size()); ++node)
          if (result_[block][direction][node].empty()) correct({block, direction, node});
    return std::move(result_);
  }

 private:
  static std::vector<double> all_nodes(const std::vector<double>& ends, int order) {
    const std::vector<double>& gll = spectral::gll_points(order);
    std::vector<double> nodes{ends.front()};
    for (std::size_t k = 1; k < ends.size(); ++k)
      for (int i = 1; i <= order; ++i)
        nodes.push_back(i == order ? ends[k] : ends[k - 1] * (1 - gll[i]) / 2 + ends[k] * (1 + gll[i]) / 2);
    return nodes;
  }

  bool is_reversed(int block, int side) const { return blocks_.block2arcs[block][side].is_backwards != (side >= 2); }

  std::array<std::vector<double>, 4> side_fractions(int block) const {
    std::array<std::vector<double>, 4> fractions;
    for (int side = 0; side < 4; ++side) {
      fractions[side] = nodes_[blocks_.block2arcs[block][side].arc];
      if (!is_reversed(block, side)) continue;
      std::reverse(fractions[side].begin(), fractions[side].end());
      for (double& f : fractions[side]) f = 1 - f;
    }
    return fractions;
  }

  /// The end of the piece that continues beyond an end of a piece; block -1: none does.
  PieceEnd beyond(const PieceEnd& at) const {
    const int side = side_of(at.piece.direction, at.end), arc = blocks_.block2arcs[at.piece.block][side].arc;
    const std::vector<mesh::BlockSide>& sides = arc_sides_[arc];
    if (sides.size() != 2 || separates_faces(blocks_, blocks_.arcs[arc], curve_region_)) return {};
    const bool is_first = sides[0].block == at.piece.block && sides[0].side == side;
    const mesh::BlockSide& other = sides[is_first ? 1 : 0];
    const int last = static_cast<int>(nodes_[arc].size()) - 1;
    const bool turns = is_reversed(at.piece.block, side) != is_reversed(other.block, other.side);
    return {{other.block, other.side % 2, turns ? last - at.piece.node : at.piece.node},
            other.side == 0 || other.side == 3 ? 0 : 1};
  }

  /// The pieces of a whole line, each with the end at which it is entered.
  std::vector<PieceEnd> whole_line(const PieceId& start, bool& is_closed) const {
    const auto is_start = [&](const PieceId& p) {
      return p.block == start.block && p.direction == start.direction && p.node == start.node;
    };
    PieceEnd first{start, 0};
    is_closed = false;
    for (PieceEnd before = beyond(first); before.piece.block >= 0; before = beyond(first)) {
      first = {before.piece, 1 - before.end};
      if ((is_closed = is_start(first.piece))) break;
    }
    std::vector<PieceEnd> line{first};
    for (;;) {
      const PieceEnd next = beyond({line.back().piece, 1 - line.back().end});
      if (next.piece.block < 0 || (is_closed && is_start(next.piece))) return line;
      line.push_back(next);
    }
  }

  LinePiece piece_of(const PieceEnd& at) const {
    const layers::BlockLine& line = pieces_[at.piece.direction][at.piece.block][at.piece.node];
    LinePiece piece{line.length, line.sizes, {}, {}};
    if (line.before > 0) piece.before = {line.before_size, std::log(line.before / line.before_size)};
    if (line.after > 0) piece.after = {line.after_size, std::log(line.after / line.after_size)};
    if (at.end == 1) {
      std::reverse(piece.sizes.begin(), piece.sizes.end());
      std::swap(piece.before, piece.after);
    }
    return piece;
  }

  void correct(const PieceId& start) {
    bool is_closed = false;
    const std::vector<PieceEnd> line = whole_line(start, is_closed);
    std::vector<LinePiece> pieces;
    pieces.reserve(line.size());
    for (const PieceEnd& at : line) pieces.push_back(piece_of(at));
    std::vector<std::vector<double>> lengths = corrected_lengths(pieces, is_closed, limit_);
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i].end == 1) std::reverse(lengths[i].begin(), lengths[i].end());
      result_[line[i].piece.block][line[i].piece.direction][line[i].piece.node] = std::move(lengths[i]);
    }
  }

  const BlockLayout& blocks_;
  double limit_;
  std::vector<int> curve_region_;
  mesh::ArcSides arc_sides_;
  std::vector<std::vector<double>> nodes_;  ///< by arc: fractions of all nodes
  /// By direction, block and node.
  std::array<std::vector<std::vector<layers::BlockLine>>, 2> pieces_;
  BlockLines result_;
};

}  // namespace

BlockLines line_intervals(const sizing::MeasuredLayout& measured, const layers::WallPlan& walls,
                          const sizing::ArcDivisions& divisions, double limit, int order) {
  return Lines(measured, walls, divisions, limit, order).corrected();
}

}  // namespace quadrille::growth
