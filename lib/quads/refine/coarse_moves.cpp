#include "refine/coarse_moves.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "refine/placed_vertices.hpp"

namespace quadrille::refine {
namespace {

Vec2 times(const std::array<double, 3>& h, Vec2 g) { return {h[0] * g.x + h[1] * g.y, h[1] * g.x + h[2] * g.y}; }

std::array<double, 3> inverse(const std::array<double, 3>& h) {
  const double det = h[0] * h[2] - h[1] * h[1];
  return det > 0 ? std::array{h[2] / det, -h[1] / det, h[0] / det} : std::array<double, 3>{};
}

std::vector<int> all_lines(int count) {
  std::vector<int> lines(count);
  std::iota(lines.begin(), lines.end(), 0);
  return lines;
}

/// Every second, counted from both ends, so that the blocks on both sides of a line take the same.
std::vector<int> every_second(const std::vector<int>& lines) {
  const int last = static_cast<int>(lines.size()) - 1;
  std::vector<int> kept;
  for (int k = 0; k <= last; ++k)
    if (std::min(k, last - k) % 2 == 0) kept.push_back(lines[k]);
  return kept;
}

/// A line between two that are kept.
struct Between {
  int line = 0, low = 0, high = 0;
  double weight = 0;  ///< of the second

  bool is_kept() const { return low == high; }
};

std::vector<Between> between(const std::vector<int>& lines, const std::vector<int>& kept) {
  std::vector<Between> places;
  std::size_t next = 0;
  for (const int line : lines) {
    if (line > kept[next]) ++next;
    const int high = kept[next], low = line == high ? high : kept[next - 1];
    places.push_back({line, low, high, low == high ? 0 : static_cast<double>(line - low) / (high - low)});
  }
  return places;
}

}  // namespace

CoarseMoves::CoarseMoves(const RelaxProblem& problem) : problem_(problem) {
  std::vector<BlockGrid> grids;
  for (VertexGrid& of : block_vertices(problem))
    grids.push_back({std::move(of.vertices), of.columns + 1, all_lines(of.columns + 1), all_lines(of.rows + 1)});
  do {
    add_level(grids);
  } while (!levels_.back().links.empty());
}

void CoarseMoves::add_level(std::vector<BlockGrid>& grids) {
  Level level;
  std::vector<bool> is_done(problem_.num_vertices(), false);
  for (BlockGrid& grid : grids) {
    const std::vector<int> columns = every_second(grid.columns), rows = every_second(grid.rows);
    const auto at = [&grid](int column, int row) { return grid.vertices[row * grid.width + column]; };
    for (const Between& t : between(grid.rows, rows))
      for (const Between& s : between(grid.columns, columns)) {
        const int vertex = at(s.line, t.line);
        if (is_done[vertex]) continue;
        is_done[vertex] = true;
        level.vertices.push_back(vertex);
        if (s.is_kept() && t.is_kept()) continue;
        const auto link = [&](int column, int row, double weight) {
          if (weight > 0) level.links.push_back({vertex, at(column, row), weight});
        };
        link(s.low, t.low, (1 - s.weight) * (1 - t.weight));
        link(s.high, t.low, s.weight * (1 - t.weight));
        link(s.low, t.high, (1 - s.weight) * t.weight);
        link(s.high, t.high, s.weight * t.weight);
      }
    grid.columns = columns, grid.rows = rows;
  }
  levels_.push_back(std::move(level));
}

void CoarseMoves::set_blocks(const DiagonalBlocks& blocks, const std::vector<Vec2>& tangents) {
  tangents_ = tangents;
  inverse_.assign(blocks.size(), {});
  for (int v = 0; v < problem_.num_vertices(); ++v) {
    if (problem_.is_fixed[v]) continue;
    const Vec2 t = tangents[v];
    const double along = 1 / blocks[v][0];
    inverse_[v] = problem_.follow.on_boundary(v) < 0
                      ? inverse(blocks[v])
                      : std::array{along * t.x * t.x, along * t.x * t.y, along * t.y * t.y};
  }
}

VertexMoves CoarseMoves::operator()(const VertexMoves& gradient) const {
  const auto slides = [&](std::size_t v) { return problem_.follow.on_boundary(static_cast<int>(v)) >= 0; };
  VertexMoves rest = gradient;
  for (std::size_t v = 0; v < rest.size(); ++v)
    if (slides(v)) rest[v] = gradient[v].x * tangents_[v];
  std::vector<VertexMoves> parts;
  for (const Level& level : levels_) {
    VertexMoves& part = parts.emplace_back(level.vertices.size());
    for (std::size_t k = 0; k < part.size(); ++k) part[k] = times(inverse_[level.vertices[k]], rest[level.vertices[k]]);
    for (const Link& link : level.links) rest[link.leader] += link.weight * rest[link.vertex];
  }
  VertexMoves moves(gradient.size());
  for (std::size_t l = levels_.size(); l-- > 0;) {
    const Level& level = levels_[l];
    for (const Link& link : level.links) moves[link.vertex] += link.weight * moves[link.leader];
    for (std::size_t k = 0; k < level.vertices.size(); ++k) moves[level.vertices[k]] += parts[l][k];
  }
  for (std::size_t v = 0; v < moves.size(); ++v) {
    if (problem_.is_fixed[v])
      moves[v] = {};
    else if (slides(v))
      moves[v] = {dot(moves[v], tangents_[v]), 0};
  }
  problem_.join_twins(moves);
  return moves;
}

}  // namespace quadrille::refine
