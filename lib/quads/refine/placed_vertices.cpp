#include "refine/placed_vertices.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace quadrille::refine {
namespace {

/// Of the start of the problem, by vertex.
std::vector<Vec2> start_positions(const RelaxProblem& problem) {
  std::vector<Vec2> positions(problem.num_vertices());
  for (int elem = 0; elem < problem.start.num_elems(); ++elem)
    for (int c = 0; c < 4; ++c)
      positions[problem.follow.elem_vertices()[elem][c]] = problem.start.nodes[side_start(problem.start, elem, c)];
  return positions;
}

}  // namespace

/// Elements of a block come row by row; neighbours in a row share a side.
std::vector<VertexGrid> block_vertices(const RelaxProblem& problem) {
  std::vector<VertexGrid> grids;
  const auto& vertices = problem.follow.elem_vertices();
  const std::vector<int>& block = problem.start.elem_block;
  const int count = static_cast<int>(block.size());
  for (int first = 0, end = 0; first < count; first = end) {
    while (end < count && block[end] == block[first]) ++end;
    int columns = 1;
    while (first + columns < end && vertices[first + columns][0] == vertices[first + columns - 1][1]) ++columns;
    const int rows = (end - first) / columns;
    VertexGrid grid{block[first], columns, rows, {}};
    for (int j = 0; j <= rows; ++j)
      for (int i = 0; i <= columns; ++i) {
        const auto& corners = vertices[first + std::min(j, rows - 1) * columns + std::min(i, columns - 1)];
        grid.vertices.push_back(corners[j < rows ? (i < columns ? 0 : 1) : (i < columns ? 3 : 2)]);
      }
    grids.push_back(std::move(grid));
  }
  return grids;
}

/// Of a line with `count` intervals the vertex `index`, on the line with `other_count`.
PlacedVertices::OnLine PlacedVertices::on_line(int index, int count, int other_count) {
  const double at = static_cast<double>(index) * other_count / count;
  const int low = std::min(static_cast<int>(at), other_count - 1);
  return {low, at - low};
}

PlacedVertices::Place PlacedVertices::place(const RelaxProblem& problem, int vertex, Vec2 start, Vec2 move) {
  const int b = problem.follow.on_boundary(vertex);
  if (b < 0) return {start + move};
  const SlidingVertex& on_curve = problem.boundary.vertices()[b];
  return {problem.boundary.at(b, move.x).position, on_curve.loop, on_curve.length + move.x};
}

PlacedVertices::PlacedVertices(const RelaxProblem& problem, const VertexMoves& moves) {
  const std::vector<Vec2> start = start_positions(problem);
  for (const VertexGrid& of : block_vertices(problem)) {
    if (of.block >= std::ssize(grids_)) grids_.resize(of.block + 1);
    Grid& grid = grids_[of.block];
    grid = {of.columns, of.rows, {}};
    for (const int v : of.vertices) grid.places.push_back(place(problem, v, start[v], moves[v]));
  }
}

/// Of a vertex that is at `from`, to the place (s, t) of the grid.
Vec2 PlacedVertices::move(const RelaxProblem& problem, const Place& from, const Grid& grid, OnLine s, OnLine t) const {
  const auto corner = [&](int i, int j) -> const Place& {
    return grid.places[(t.low + j) * (grid.columns + 1) + s.low + i];
  };
  const std::array<double, 4> weights{(1 - s.part) * (1 - t.part), s.part * (1 - t.part), (1 - s.part) * t.part,
                                      s.part * t.part};
  Vec2 sum;
  double slide = 0;
  for (int k = 0; k < 4; ++k) {
    if (weights[k] == 0) continue;
    const Place& place = corner(k % 2, k / 2);
    sum += weights[k] * (place.position - from.position);
    if (from.loop < 0) continue;
    if (place.loop != from.loop) return {};
    slide += weights[k] * std::remainder(place.length - from.length, problem.boundary.loop_length(from.loop));
  }
  return from.loop < 0 ? sum : Vec2{slide, 0};
}

VertexMoves PlacedVertices::moves(const RelaxProblem& problem) const {
  const std::vector<Vec2> start = start_positions(problem);
  VertexMoves moves(problem.num_vertices());
  std::vector<bool> is_done = problem.is_fixed;
  for (const VertexGrid& of : block_vertices(problem)) {
    if (of.block >= std::ssize(grids_) || grids_[of.block].places.empty()) continue;
    const Grid& grid = grids_[of.block];
    for (int j = 0; j <= of.rows; ++j)
      for (int i = 0; i <= of.columns; ++i) {
        const int v = of.at(i, j);
        if (is_done[v]) continue;
        is_done[v] = true;
        moves[v] = move(problem, place(problem, v, start[v], {}), grid, on_line(i, of.columns, grid.columns),
                        on_line(j, of.rows, grid.rows));
      }
  }
  problem.join_twins(moves);
  return moves;
}

}  // namespace quadrille::refine
