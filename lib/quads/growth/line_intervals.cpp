#include "growth/line_intervals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "growth/limit_growth.hpp"
#include "growth/line_correction.hpp"
#include "mesh/chords.hpp"
#include "model/interfaces.hpp"

namespace quadrille::growth {
namespace {

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

/// Whether a side runs against rising s (sides 0, 2) or t (1, 3) of its block.
bool is_reversed_side(const BlockLayout& blocks, int block, int side) {
  return blocks.block2arcs[block][side].is_backwards != (side >= 2);
}

/// Lines of nodes that cross several blocks, from the boundary to the boundary.
class LinePaths {
 public:
  /// `num_nodes`: by arc. Keeps a reference to the blocks.
  LinePaths(const BlockLayout& blocks, std::vector<int> num_nodes)
      : blocks_(blocks),
        num_nodes_(std::move(num_nodes)),
        curve_region_(curve_regions(blocks.face)),
        arc_sides_(mesh::sides_of_arcs(blocks)) {}

  /// The whole line that has this piece.
  LinePath through(const PieceId& start) const {
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

 private:
  /// The end of the piece that continues beyond an end of a piece; block -1: none does.
  PieceEnd beyond(const PieceEnd& at) const {
    const int side = at.piece.direction == 0 ? 2 * at.end : 3 - 2 * at.end;
    const int arc = blocks_.block2arcs[at.piece.block][side].arc;
    const std::vector<mesh::BlockSide>& sides = arc_sides_[arc];
    if (sides.size() != 2 || separates_faces(blocks_, blocks_.arcs[arc], curve_region_)) return {};
    const bool is_first = sides[0].block == at.piece.block && sides[0].side == side;
    const mesh::BlockSide& other = sides[is_first ? 1 : 0];
    const bool turns =
        is_reversed_side(blocks_, at.piece.block, side) != is_reversed_side(blocks_, other.block, other.side);
    return {{other.block, other.side % 2, turns ? num_nodes_[arc] - 1 - at.piece.node : at.piece.node},
            other.side == 0 || other.side == 3 ? 0 : 1};
  }

  const BlockLayout& blocks_;
  std::vector<int> num_nodes_;
  std::vector<int> curve_region_;
  mesh::ArcSides arc_sides_;
};

/// By direction, block and node.
using AllPieces = std::array<std::vector<std::vector<layers::BlockLine>>, 2>;

/// The fractions of all nodes on the sides of a block, by rising s or t.
std::array<std::vector<double>, 4> side_fractions(const layers::WallPlan& walls, const BlockLayout& blocks, int block,
                                                  const sizing::ArcDivisions& divisions, int order) {
  std::array<std::vector<double>, 4> fractions;
  for (int side = 0; side < 4; ++side) {
    const int arc = blocks.block2arcs[block][side].arc;
    fractions[side] = walls.nodes_on(arc, divisions[arc], order);
    if (is_reversed_side(blocks, block, side)) sizing::reverse_fractions(fractions[side]);
  }
  return fractions;
}

LinePiece line_piece(const layers::BlockLine& line, int entered_at) {
  LinePiece piece{line.length, line.sizes, {}, {}};
  if (line.before > 0) piece.before = {line.before_size, std::log(line.before / line.before_size)};
  if (line.after > 0) piece.after = {line.after_size, std::log(line.after / line.after_size)};
  if (entered_at == 1) {
    std::reverse(piece.sizes.begin(), piece.sizes.end());
    std::swap(piece.before, piece.after);
  }
  return piece;
}

/// Whether the intervals of a piece can change.
using IsFree = std::vector<std::array<bool, 2>>;  // by block and direction

/// The pieces of a path that are free. Pieces beside others end there as at layers.
std::vector<LinePiece> free_pieces(const LinePath& path, const AllPieces& all, const IsFree& is_free) {
  const int count = static_cast<int>(path.pieces.size());
  const auto at = [&](int i) { return path.pieces[(i + count) % count]; };
  const auto piece_at = [&](int i) {
    const auto& [id, end] = at(i);
    return line_piece(all[id.direction][id.block][id.node], end);
  };
  const auto is_fixed = [&](int i) {
    if (!path.is_closed && (i < 0 || i >= count)) return false;
    return !is_free[at(i).piece.block][at(i).piece.direction];
  };
  std::vector<LinePiece> pieces;
  for (int i = 0; i < count; ++i) {
    if (is_fixed(i)) continue;
    pieces.push_back(piece_at(i));
    if (is_fixed(i - 1)) pieces.back().before = {piece_at(i - 1).sizes.back(), 0};
    if (is_fixed(i + 1)) pieces.back().after = {piece_at(i + 1).sizes.front(), 0};
  }
  return pieces;
}

/// Corrects the intervals of the pieces of a path that are free; in the direction of their sides.
void correct_path(const LinePath& path, const AllPieces& all, const IsFree& is_free, double limit, BlockLines& result) {
  std::vector<std::vector<double>> lengths = corrected_lengths(free_pieces(path, all, is_free), path.is_closed, limit);
  std::size_t next = 0;
  for (const auto& [piece, end] : path.pieces) {
    if (!is_free[piece.block][piece.direction]) continue;
    if (end == 1) std::reverse(lengths[next].begin(), lengths[next].end());
    result[piece.block][piece.direction][piece.node] = std::move(lengths[next++]);
  }
}

BlockLines corrected(const BlockLayout& blocks, const AllPieces& all, const IsFree& is_free,
                     const sizing::ArcDivisions& divisions, int order, double limit) {
  std::vector<int> num_nodes;
  for (const sizing::ArcDivision& division : divisions) num_nodes.push_back(division.num_intervals() * order + 1);
  const LinePaths paths(blocks, std::move(num_nodes));
  const double line_limit = std::pow(limit, 1 - growth_constants.margin);
  BlockLines result(blocks.num_blocks());
  for (int block = 0; block < blocks.num_blocks(); ++block)
    for (const int direction : {0, 1}) result[block][direction].resize(all[direction][block].size());
  for (int block = 0; block < blocks.num_blocks(); ++block)
    for (const int direction : {0, 1})
      for (int node = 1; node + 1 < std::ssize(all[direction][block]); ++node)
        if (is_free[block][direction] && result[block][direction][node].empty())
          correct_path(paths.through({block, direction, node}), all, is_free, line_limit, result);
  return result;
}

/// As measured_line, from the positions of vertices. `layers`: their numbers at the beginning and the end.
layers::BlockLine line_of_vertices(const BlockVertices& vertices, int direction, int node, int count,
                                   const std::array<int, 2>& layers) {
  const auto length = [&](int k) {
    return distance(vertices.at(direction, node, k), vertices.at(direction, node, k + 1));
  };
  layers::BlockLine line;
  for (int k = layers[0]; k < count - layers[1]; ++k) {
    line.sizes.push_back(length(k));
    line.length += line.sizes.back();
  }
  if (layers[0] > 0) line.before = line.before_size = length(layers[0] - 1);
  if (layers[1] > 0) line.after = line.after_size = length(count - layers[1]);
  return line;
}

AllPieces pieces_of_mesh(const std::vector<BlockVertices>& blocks, const layers::WallPlan& walls, int order) {
  AllPieces pieces;
  for (int block = 0; block < std::ssize(blocks); ++block)
    for (const int direction : {0, 1}) {
      const BlockVertices& own = blocks[block];
      const int across = direction == 0 ? own.columns() : own.rows(),
                along = direction == 0 ? own.rows() : own.columns();
      std::vector<layers::BlockLine> lines(across * order + 1);
      for (int node = 1; node + 1 < std::ssize(lines); ++node)
        lines[node] = line_of_vertices(own, direction, node, along, walls.num_fixed_along(block, direction));
      pieces[direction].push_back(std::move(lines));
    }
  return pieces;
}

}  // namespace

Vec2 BlockVertices::position(int i, int j) const {
  const int order = mesh_.order, width = order + 1;
  const int column = std::min(i / order, columns_ - 1), row = std::max(0, (j - 1) / order);
  const std::size_t elem = first_ + static_cast<std::size_t>(row) * columns_ + column;
  return mesh_.nodes[mesh_.elem_nodes[elem * width * width + (j - row * order) * width + i - column * order]];
}

std::vector<BlockVertices> block_vertices(const BlockLayout& blocks, const sizing::ArcDivisions& divisions,
                                          const QuadMesh& mesh) {
  std::vector<BlockVertices> vertices;
  std::size_t first = 0;
  for (const auto& sides : blocks.block2arcs) {
    const int columns = divisions[sides[0].arc].num_intervals(), rows = divisions[sides[1].arc].num_intervals();
    vertices.emplace_back(mesh, first, columns, rows);
    first += static_cast<std::size_t>(rows) * columns;
  }
  return vertices;
}

BlockLines line_intervals(const sizing::MeasuredLayout& measured, const layers::WallPlan& walls,
                          const sizing::ArcDivisions& divisions, double limit, int order) {
  const BlockLayout& blocks = measured.blocks();
  AllPieces pieces;
  for (int block = 0; block < blocks.num_blocks(); ++block) {
    const layers::LayeredBlock layered =
        layers::layered_block(walls, measured, block, side_fractions(walls, blocks, block, divisions, order));
    for (const int direction : {0, 1})
      pieces[direction].push_back(layers::block_lines(layered, direction, order, blocks.face));
  }
  return corrected(blocks, pieces, IsFree(blocks.num_blocks(), {true, true}), divisions, order, limit);
}

void correct_factors(const sizing::MeasuredLayout& measured, const layers::WallPlan& walls,
                     const sizing::ArcDivisions& divisions, const QuadMesh& mesh, double limit, LinePlan& lines) {
  const BlockLayout& blocks = measured.blocks();
  IsFree is_free;
  for (const layers::BlockLineLengths& own : lines.lengths) is_free.push_back({!own[0].empty(), !own[1].empty()});
  const AllPieces pieces = pieces_of_mesh(block_vertices(blocks, divisions, mesh), walls, mesh.order);
  BlockLines factors = corrected(blocks, pieces, is_free, divisions, mesh.order, limit);
  for (int block = 0; block < blocks.num_blocks(); ++block)
    for (const int direction : {0, 1})
      for (std::size_t node = 0; node < factors[block][direction].size(); ++node) {
        std::vector<double>& own = factors[block][direction][node];
        for (std::size_t k = 0; k < own.size(); ++k) {
          own[k] /= pieces[direction][block][node].sizes[k];
          if (!lines.factors.empty()) own[k] *= lines.factors[block][direction][node][k];
        }
      }
  lines.factors = std::move(factors);
}

}  // namespace quadrille::growth
