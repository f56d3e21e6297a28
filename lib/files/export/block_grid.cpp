#include "export/block_grid.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>

#include "export/edge_numbering.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::exports {

namespace {

constexpr SkeletonEdge nowhere{-1, -1};

SkeletonEdge turned(SkeletonEdge e, int quarters) { return {e.elem, (e.side + quarters) % 4}; }

/// By element and side: the same side as a side of the neighbour in the same block.
std::vector<SkeletonEdge> neighbours(const QuadMesh& mesh) {
  const EdgeNumbering numbering = number_parts(mesh);
  std::vector<SkeletonEdge> beyond(numbering.elem2edges.size(), nowhere);
  for (std::size_t k = 0; k < beyond.size(); ++k) {
    const NumberedEdge& edge = numbering.edges[numbering.elem2edges[k]];
    const int elem = static_cast<int>(k / 4), side = static_cast<int>(k % 4);
    if ((edge.elem == elem && edge.edge == side) || mesh.elem_block[edge.elem] != mesh.elem_block[elem]) continue;
    beyond[k] = {edge.elem, edge.edge};
    beyond[4 * edge.elem + edge.edge] = {elem, side};
  }
  return beyond;
}

/// Walks over the elements of a block. An element is given by its lower side.
class Walker {
 public:
  explicit Walker(const std::vector<SkeletonEdge>& beyond) : beyond_(beyond) {}

  bool is_corner(SkeletonEdge below) const { return across(below, 0).elem < 0 && across(below, 3).elem < 0; }

  std::optional<BlockGrid> grid(int block, SkeletonEdge corner, std::size_t num_elems) const {
    std::vector<std::vector<SkeletonEdge>> rows;
    for (SkeletonEdge first = corner; first.elem >= 0; first = above(first)) {
      rows.push_back(row(first, num_elems));
      if (rows.back().size() != rows.front().size() || rows.size() * rows.front().size() > num_elems) return {};
    }
    if (rows.size() * rows.front().size() != num_elems) return {};
    BlockGrid grid{block, static_cast<int>(rows.front().size()), static_cast<int>(rows.size()), {}};
    for (const auto& row : rows) grid.cells.insert(grid.cells.end(), row.begin(), row.end());
    return grid;
  }

 private:
  SkeletonEdge across(SkeletonEdge below, int quarters) const {
    return beyond_[4 * below.elem + (below.side + quarters) % 4];
  }
  SkeletonEdge above(SkeletonEdge below) const { return across(below, 2); }

  /// Stops after one element more than the block has: a ring has no end.
  std::vector<SkeletonEdge> row(SkeletonEdge first, std::size_t num_elems) const {
    std::vector<SkeletonEdge> elems;
    for (SkeletonEdge at = first; at.elem >= 0 && elems.size() <= num_elems;) {
      elems.push_back(at);
      const SkeletonEdge left = across(at, 1);  // of the next one
      at = left.elem < 0 ? nowhere : turned(left, 1);
    }
    return elems;
  }

  const std::vector<SkeletonEdge>& beyond_;
};

/// A mesh node inside a side of a grid: the line through it has `position` elements before it.
struct GridPosition {
  std::size_t grid = 0;
  bool is_i = true;  ///< i = position; else j = position
  int position = 0;
};

class Cutter {
 public:
  Cutter(const QuadMesh& mesh, const std::vector<BlockGrid>& grids) : grids_(grids), cuts_(grids.size()) {
    for (std::size_t g = 0; g < grids.size(); ++g) {
      vertices_.push_back(grids[g].vertices(mesh));
      const int num_i = grids[g].num_i, num_j = grids[g].num_j;
      for (int i = 1; i < num_i; ++i)
        for (const int j : {0, num_j}) positions_[vertex(g, i, j)].push_back({g, true, i});
      for (int j = 1; j < num_j; ++j)
        for (const int i : {0, num_i}) positions_[vertex(g, i, j)].push_back({g, false, j});
    }
  }

  void cut(std::vector<int> nodes) {
    while (!nodes.empty()) {
      const auto positions = positions_.find(nodes.back());
      nodes.pop_back();
      if (positions == positions_.end()) continue;
      for (const GridPosition& p : positions->second) {
        if (!cuts_[p.grid][p.is_i ? 0 : 1].insert(p.position).second) continue;
        const BlockGrid& g = grids_[p.grid];
        nodes.push_back(p.is_i ? vertex(p.grid, p.position, 0) : vertex(p.grid, 0, p.position));
        nodes.push_back(p.is_i ? vertex(p.grid, p.position, g.num_j) : vertex(p.grid, g.num_i, p.position));
      }
    }
  }

  std::vector<BlockGrid> pieces() const {
    std::vector<BlockGrid> all;
    for (std::size_t g = 0; g < grids_.size(); ++g) {
      const std::vector<int> is = bounds(cuts_[g][0], grids_[g].num_i), js = bounds(cuts_[g][1], grids_[g].num_j);
      for (std::size_t j = 1; j < js.size(); ++j)
        for (std::size_t i = 1; i < is.size(); ++i) all.push_back(piece(grids_[g], is[i - 1], is[i], js[j - 1], js[j]));
    }
    return all;
  }

 private:
  int vertex(std::size_t g, int i, int j) const { return vertices_[g][j * (grids_[g].num_i + 1) + i]; }

  static std::vector<int> bounds(const std::set<int>& cuts, int count) {
    std::vector<int> all{0};
    all.insert(all.end(), cuts.begin(), cuts.end());
    all.push_back(count);
    return all;
  }

  static BlockGrid piece(const BlockGrid& grid, int i0, int i1, int j0, int j1) {
    BlockGrid part{grid.block, i1 - i0, j1 - j0, {}};
    for (int j = j0; j < j1; ++j)
      for (int i = i0; i < i1; ++i) part.cells.push_back(grid.cell(i, j));
    return part;
  }

  const std::vector<BlockGrid>& grids_;
  std::vector<std::vector<int>> vertices_;
  std::map<int, std::vector<GridPosition>> positions_;  ///< by mesh node
  std::vector<std::array<std::set<int>, 2>> cuts_;      ///< by grid: in i and in j
};

/// Distance of x from the line through a and b.
double from_line(Vec2 x, Vec2 a, Vec2 b) { return std::abs(cross(normalized(b - a), x - a)); }

bool is_straight(const QuadMesh& mesh, const DividedEdge& edge) {
  const Vec2 a = edge.vertices.front(), b = edge.vertices.back();
  const double tol = 1e-10 * distance(a, b) + 1e-14 * mesh.face.diameter;
  if (distance(a, b) <= tol) return false;
  return std::all_of(edge.inner.begin(), edge.inner.end(), [&](Vec2 x) { return from_line(x, a, b) <= tol; });
}

/// blockMesh's mean in one direction: two edges, one on each side, at weights of their own.
struct TwoEdges {
  Vec2 straight, curved;  ///< mean of the points on the chords; mean deviation of the edges from them
};

TwoEdges mean(double low_weight, Vec2 low_chord, Vec2 low, double high_weight, Vec2 high_chord, Vec2 high) {
  const double sum = low_weight + high_weight;
  const double l = low_weight / sum, h = high_weight / sum;
  return {l * low_chord + h * high_chord, l * (low - low_chord) + h * (high - high_chord)};
}

}  // namespace

std::vector<SkeletonEdge> BlockGrid::side(int k) const {
  std::vector<SkeletonEdge> sides;
  const int count = k % 2 == 0 ? num_i : num_j;
  for (int step = 0; step < count; ++step) {
    const int at = k < 2 ? step : count - 1 - step;
    sides.push_back(turned(k % 2 == 0 ? cell(at, k == 0 ? 0 : num_j - 1) : cell(k == 1 ? num_i - 1 : 0, at), k));
  }
  return sides;
}

std::vector<int> BlockGrid::vertices(const QuadMesh& mesh) const {
  std::vector<int> nodes;
  for (int j = 0; j <= num_j; ++j)
    for (int i = 0; i <= num_i; ++i) {
      const bool is_last_i = i == num_i, is_last_j = j == num_j;
      const int corner = is_last_j ? (is_last_i ? 2 : 3) : (is_last_i ? 1 : 0);
      const SkeletonEdge at = turned(cell(i - is_last_i, j - is_last_j), corner);
      nodes.push_back(side_start(mesh, at.elem, at.side));
    }
  return nodes;
}

std::vector<BlockGrid> cut_grids(const QuadMesh& mesh, const std::vector<BlockGrid>& grids, std::vector<int> nodes) {
  Cutter cutter(mesh, grids);
  cutter.cut(std::move(nodes));
  return cutter.pieces();
}

std::optional<std::vector<BlockGrid>> block_grids(const QuadMesh& mesh) {
  const std::vector<SkeletonEdge> beyond = neighbours(mesh);
  const Walker walker(beyond);
  std::vector<std::size_t> num_elems(mesh.block_names.size(), 0);
  std::vector<SkeletonEdge> corners(mesh.block_names.size(), nowhere);
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const int block = mesh.elem_block[elem];
    ++num_elems[block];
    for (int side = 0; side < 4 && corners[block].elem < 0; ++side)
      if (walker.is_corner({elem, side})) corners[block] = {elem, side};
  }
  std::vector<BlockGrid> grids;
  for (std::size_t block = 0; block < corners.size(); ++block) {
    std::optional<BlockGrid> grid;
    if (corners[block].elem >= 0) grid = walker.grid(static_cast<int>(block), corners[block], num_elems[block]);
    if (!grid) return {};
    grids.push_back(std::move(*grid));
  }
  return grids;
}

std::vector<double> DividedEdge::weights() const {
  std::vector<double> sums{0};
  for (const double fraction : fractions) sums.push_back(sums.back() + fraction);
  sums.back() = 1;
  return sums;
}

DividedEdge DividedEdge::reversed() const {
  DividedEdge other = *this;
  std::reverse(other.vertices.begin(), other.vertices.end());
  std::reverse(other.fractions.begin(), other.fractions.end());
  std::reverse(other.inner.begin(), other.inner.end());
  return other;
}

DividedEdge divided_edge(const QuadMesh& mesh, const std::vector<SkeletonEdge>& sides) {
  const std::vector<double> between{-0.5, 0, 0.5};
  const Eigen::MatrixXd basis = spectral::interpolation_matrix(spectral::gll_points(mesh.order), between);
  DividedEdge edge;
  edge.vertices.push_back(mesh.nodes[side_start(mesh, sides.front().elem, sides.front().side)]);
  for (const SkeletonEdge& side : sides) {
    const std::vector<int> nodes = side_nodes(mesh, side.elem, side.side);
    Vec2 previous = edge.vertices.back();
    double length = 0;
    const auto go_to = [&](Vec2 x) {
      length += distance(previous, x);
      edge.inner.push_back(previous = x);
    };
    for (int row = 0; mesh.order > 1 && row < 3; ++row) {
      Vec2 x;
      for (int k = 0; k <= mesh.order; ++k) x += basis(row, k) * mesh.nodes[nodes[k]];
      go_to(x);
    }
    go_to(mesh.nodes[nodes.back()]);
    edge.vertices.push_back(previous);
    edge.fractions.push_back(length);
  }
  edge.inner.pop_back();
  const double sum = std::accumulate(edge.fractions.begin(), edge.fractions.end(), 0.0);
  for (double& fraction : edge.fractions) fraction /= sum;
  edge.is_straight = is_straight(mesh, edge);
  return edge;
}

std::vector<Vec2> block_mesh_points(const DividedEdge& bottom, const DividedEdge& right, const DividedEdge& top,
                                    const DividedEdge& left) {
  const Vec2 a = bottom.vertices.front(), b = bottom.vertices.back(), c = top.vertices.back(), d = left.vertices.back();
  const std::vector<double> wb = bottom.weights(), wr = right.weights(), wt = top.weights(), wl = left.weights();
  std::vector<Vec2> points;
  for (int j = 0; j <= left.num_cells(); ++j)
    for (int i = 0; i <= bottom.num_cells(); ++i) {
      const double s = wb[i], u = wt[i], t = wl[j], v = wr[j];  // fractions: below, above, left, right
      const TwoEdges along_i = mean((1 - s) * (1 - t) + s * (1 - v), a + s * (b - a), bottom.vertices[i],
                                    (1 - u) * t + u * v, d + u * (c - d), top.vertices[i]);
      const TwoEdges along_j = mean((1 - t) * (1 - s) + t * (1 - u), a + t * (d - a), left.vertices[j],
                                    (1 - v) * s + v * u, b + v * (c - b), right.vertices[j]);
      const double wa = (1 - s) * (1 - t), wbc = s * (1 - v), wc = u * v, wd = (1 - u) * t;
      const Vec2 corners = (wa * a + wbc * b + wc * c + wd * d) / (wa + wbc + wc + wd);
      points.push_back((along_i.straight + along_j.straight + corners) / 3 + along_i.curved + along_j.curved);
    }
  return points;
}

}  // namespace quadrille::exports
