#include "growth/line_intervals.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "growth/block_vertices.hpp"
#include "growth/limit_growth.hpp"
#include "growth/line_correction.hpp"
#include "growth/line_paths.hpp"
#include "layers/request_layers.hpp"

namespace quadrille::growth {
namespace {

/// By direction, block and node.
using AllPieces = std::array<std::vector<std::vector<layers::BlockLine>>, 2>;

/// Lines aim at less than the limit: see GrowthConstants::margin.
double line_limit(double limit) { return std::pow(limit, 1 - growth_constants.margin); }

BlockLines empty_lines(const AllPieces& pieces) {
  BlockLines lines(pieces[0].size());
  for (std::size_t block = 0; block < lines.size(); ++block)
    for (const int direction : {0, 1}) lines[block][direction].resize(pieces[direction][block].size());
  return lines;
}

/// By arc: fractions of all nodes.
std::vector<std::vector<double>> arc_fractions(const layers::WallPlan& walls, const sizing::ArcDivisions& divisions,
                                               int order) {
  std::vector<std::vector<double>> nodes;
  for (std::size_t arc = 0; arc < divisions.size(); ++arc)
    nodes.push_back(walls.arc_nodes[arc].empty() ? layers::interval_nodes(divisions[arc].ends, order)
                                                 : walls.arc_nodes[arc]);
  return nodes;
}

std::array<std::vector<double>, 4> side_fractions(const BlockLayout& blocks,
                                                  const std::vector<std::vector<double>>& nodes, int block) {
  std::array<std::vector<double>, 4> fractions;
  for (int side = 0; side < 4; ++side) {
    fractions[side] = nodes[blocks.block2arcs[block][side].arc];
    if (!is_reversed_side(blocks, block, side)) continue;
    std::reverse(fractions[side].begin(), fractions[side].end());
    for (double& f : fractions[side]) f = 1 - f;
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
                     const std::vector<int>& num_nodes, double limit) {
  const LinePaths paths(blocks, num_nodes);
  BlockLines result = empty_lines(all);
  for (int block = 0; block < blocks.num_blocks(); ++block)
    for (const int direction : {0, 1})
      for (int node = 1; node + 1 < static_cast<int>(all[direction][block].size()); ++node)
        if (is_free[block][direction] && result[block][direction][node].empty())
          correct_path(paths.through({block, direction, node}), all, is_free, line_limit(limit), result);
  return result;
}

std::vector<int> sizes_of(const std::vector<std::vector<double>>& lists) {
  std::vector<int> sizes;
  for (const std::vector<double>& list : lists) sizes.push_back(static_cast<int>(list.size()));
  return sizes;
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

AllPieces pieces_of_mesh(const BlockLayout& blocks, const layers::WallPlan& walls,
                         const sizing::ArcDivisions& divisions, const QuadMesh& mesh) {
  AllPieces pieces;
  std::size_t first = 0;
  for (int block = 0; block < blocks.num_blocks(); ++block) {
    const auto& arcs = blocks.block2arcs[block];
    const int rows = divisions[arcs[1].arc].num_intervals(), columns = divisions[arcs[0].arc].num_intervals();
    const BlockVertices vertices(mesh, first, columns);
    first += static_cast<std::size_t>(rows) * columns;
    for (const int direction : {0, 1}) {
      const int across = direction == 0 ? columns : rows, along = direction == 0 ? rows : columns;
      const std::array<int, 2> layers{walls.num_fixed_on(block, direction == 0 ? 0 : 3),
                                      walls.num_fixed_on(block, direction == 0 ? 2 : 1)};
      std::vector<layers::BlockLine> lines(across * mesh.order + 1);
      for (int node = 1; node + 1 < std::ssize(lines); ++node)
        lines[node] = line_of_vertices(vertices, direction, node, along, layers);
      pieces[direction].push_back(std::move(lines));
    }
  }
  return pieces;
}

}  // namespace

BlockLines line_intervals(const sizing::MeasuredLayout& measured, const layers::WallPlan& walls,
                          const sizing::ArcDivisions& divisions, double limit, int order) {
  const BlockLayout& blocks = measured.blocks();
  const std::vector<std::vector<double>> nodes = arc_fractions(walls, divisions, order);
  AllPieces pieces;
  for (int block = 0; block < blocks.num_blocks(); ++block) {
    const layers::LayeredBlock layered =
        layers::layered_block(walls, measured, block, side_fractions(blocks, nodes, block));
    for (const int direction : {0, 1})
      pieces[direction].push_back(layers::block_lines(layered, direction, order, blocks.face.origin));
  }
  return corrected(blocks, pieces, IsFree(blocks.num_blocks(), {true, true}), sizes_of(nodes), limit);
}

void correct_factors(const sizing::MeasuredLayout& measured, const layers::WallPlan& walls,
                     const sizing::ArcDivisions& divisions, const QuadMesh& mesh, double limit, LinePlan& lines) {
  const BlockLayout& blocks = measured.blocks();
  std::vector<int> num_nodes;
  for (const sizing::ArcDivision& division : divisions) num_nodes.push_back(division.num_intervals() * mesh.order + 1);
  IsFree is_free;
  for (const layers::BlockLineLengths& own : lines.lengths) is_free.push_back({!own[0].empty(), !own[1].empty()});
  const AllPieces pieces = pieces_of_mesh(blocks, walls, divisions, mesh);
  BlockLines factors = corrected(blocks, pieces, is_free, num_nodes, limit);
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
