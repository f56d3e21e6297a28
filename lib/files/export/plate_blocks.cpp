#include "export/plate_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "export/periodic_edges.hpp"
#include "export/split_elements.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {
namespace {

constexpr double largest_move = 0.1;  ///< of the shortest side of the cells at a point

double shortest_side(const std::array<Vec2, 4>& corners) {
  double shortest = distance(corners[3], corners[0]);
  for (int k = 0; k < 3; ++k) shortest = std::min(shortest, distance(corners[k], corners[k + 1]));
  return shortest;
}

/// The boundary group of each side of each element; -1 inside.
std::vector<int> boundaries_of_sides(const QuadMesh& mesh, const Groups& groups) {
  std::vector<int> boundaries(4 * mesh.elem_block.size(), -1);
  for (const QuadBoundaryEdge& e : mesh.boundary_edges)
    boundaries[4 * e.elem + e.side] = groups.curve2boundary[e.curve];
  return boundaries;
}

/// A grid with its sides as blockMesh divides them and its points as blockMesh computes them.
struct DividedGrid {
  BlockGrid grid;
  std::vector<int> vertices;
  std::array<DividedEdge, 4> edges;
  std::vector<Vec2> points;

  std::array<int, 4> corners() const {
    const int width = grid.num_i + 1, last = static_cast<int>(vertices.size()) - 1;
    return {vertices[0], vertices[grid.num_i], vertices[last], vertices[last + 1 - width]};
  }
};

class Divider {
 public:
  Divider(const QuadMesh& mesh, const Groups& groups) : mesh_(mesh), boundaries_(boundaries_of_sides(mesh, groups)) {
    for (const PeriodicEdges& edges : periodic_edges(mesh)) {
      const QuadBoundaryEdge &first = mesh.boundary_edges[edges.first], &second = mesh.boundary_edges[edges.second];
      for (const bool is_end : {false, true})
        images_.emplace_back(side_node(mesh, first.elem, first.side, is_end ? mesh.order : 0),
                             side_node(mesh, second.elem, second.side, is_end ? 0 : mesh.order));
    }
  }

  std::vector<DividedGrid> divide() {
    std::vector<BlockGrid> grids = first_grids();
    std::vector<int> cuts = ends_of_names(grids);
    for (;;) {
      grids = cut_grids(mesh_, grids, std::move(cuts));
      cuts = images_of_corners(grids);
      if (!cuts.empty()) continue;
      std::vector<DividedGrid> divided;
      for (const BlockGrid& grid : grids) divided.push_back(divided_grid(grid));
      cuts = middles_of_faulty(divided);
      if (cuts.empty()) return divided;
    }
  }

  int boundary_of(const SkeletonEdge& side) const { return boundaries_[4 * side.elem + side.side]; }

 private:
  /// The blocks; single quads where a block does not have four corners.
  std::vector<BlockGrid> first_grids() const {
    if (auto grids = block_grids(mesh_)) return std::move(*grids);
    std::vector<BlockGrid> quads;
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) quads.push_back({mesh_.elem_block[elem], 1, 1, {{elem, 0}}});
    return quads;
  }

  std::vector<int> ends_of_names(const std::vector<BlockGrid>& grids) const {
    std::vector<int> nodes;
    for (const BlockGrid& grid : grids)
      for (int k = 0; k < 4; ++k) {
        const std::vector<SkeletonEdge> sides = grid.side(k);
        for (std::size_t at = 1; at < sides.size(); ++at)
          if (boundary_of(sides[at]) != boundary_of(sides[at - 1]))
            nodes.push_back(side_start(mesh_, sides[at].elem, sides[at].side));
      }
    return nodes;
  }

  /// Nodes to cut at, so that periodic sides consist of as many sides of blocks, which are images of each other.
  std::vector<int> images_of_corners(const std::vector<BlockGrid>& grids) {
    std::set<int> corners;
    if (!images_.empty())
      for (const BlockGrid& grid : grids)
        for (int k = 0; k < 4; ++k)
          corners.insert(side_start(mesh_, grid.side(k).front().elem, grid.side(k).front().side));
    std::vector<int> nodes;
    for (const auto& [a, b] : images_)
      if (const bool has_a = corners.count(a) > 0; has_a != (corners.count(b) > 0))
        if (const int node = has_a ? b : a; asked_.insert(node).second) nodes.push_back(node);
    return nodes;
  }

  DividedGrid divided_grid(const BlockGrid& grid) const {
    DividedGrid divided{grid, grid.vertices(mesh_), {}, {}};
    for (int k = 0; k < 4; ++k) {
      divided.edges[k] = divided_edge(mesh_, grid.side(k));
      if (k >= 2) divided.edges[k] = divided.edges[k].reversed();
    }
    const auto& [bottom, right, top, left] = divided.edges;
    divided.points = block_mesh_points(bottom, right, top, left);
    return divided;
  }

  std::vector<int> middles_of_faulty(const std::vector<DividedGrid>& grids) const {
    std::map<std::pair<int, int>, int> uses;  // by the ends of a side, which identify it for blockMesh
    for (const DividedGrid& d : grids)
      for (int k = 0; k < 4; ++k) uses[ends(d, k)] += boundary_of(d.grid.side(k).front()) < 0 ? 1 : 2;
    std::vector<int> nodes;
    for (const DividedGrid& d : grids) {
      bool is_faulty = !is_buildable(d);
      for (int k = 0; k < 4; ++k)
        is_faulty = is_faulty || uses[ends(d, k)] > 2 || ends(d, k).first == ends(d, k).second;
      if (is_faulty) add_middles(d, nodes);
    }
    return nodes;
  }

  static std::pair<int, int> ends(const DividedGrid& d, int k) {
    const std::array<int, 4> corners = d.corners();
    return std::minmax({corners[k], corners[(k + 1) % 4]});
  }

  bool is_buildable(const DividedGrid& d) const {
    std::array<Vec2, 4> corners;
    for (int k = 0; k < 4; ++k) corners[k] = mesh_.nodes[d.corners()[k]];
    if (!is_convex(corners)) return false;
    const int width = d.grid.num_i + 1;
    for (int j = 0; j < d.grid.num_j; ++j)
      for (int i = 0; i < d.grid.num_i; ++i)
        if (!is_cell_kept(d, {j * width + i, j * width + i + 1, (j + 1) * width + i + 1, (j + 1) * width + i}))
          return false;
    return true;
  }

  bool is_cell_kept(const DividedGrid& d, const std::array<int, 4>& locals) const {
    std::array<Vec2, 4> ours, theirs;
    double moved = 0;
    for (int k = 0; k < 4; ++k) {
      ours[k] = mesh_.nodes[d.vertices[locals[k]]];
      theirs[k] = d.points[locals[k]];
      moved = std::max(moved, distance(ours[k], theirs[k]));
    }
    return is_convex(theirs) && moved <= largest_move * shortest_side(ours);
  }

  /// Cuts on both sides of the middle if the number of cells is odd, so that cuts of a mirrored mesh are mirrored too.
  void add_middles(const DividedGrid& d, std::vector<int>& nodes) const {
    const int width = d.grid.num_i + 1;
    for (const int half : {d.grid.num_i / 2, (d.grid.num_i + 1) / 2})
      if (d.grid.num_i > 1) nodes.push_back(d.vertices[half]);
    for (const int half : {d.grid.num_j / 2, (d.grid.num_j + 1) / 2})
      if (d.grid.num_j > 1) nodes.push_back(d.vertices[half * width]);
    if (d.grid.num_i == 1 && d.grid.num_j == 1 && is_buildable(d)) {
      const Vec2 corner = mesh_.nodes[d.vertices[0]] + mesh_.face.origin;
      throw ComputeError(
          fmt::format("blockMesh identifies sides by their ends, and two sides of quads near {} have the same; "
                      "refine the mesh",
                      position_text(corner)));
    }
  }

  const QuadMesh& mesh_;
  std::vector<int> boundaries_;
  std::vector<std::pair<int, int>> images_;  ///< nodes at the ends of periodic edges
  std::set<int> asked_;                      ///< nodes at which images_of_corners has cut
};

class Collector {
 public:
  Collector(const QuadMesh& mesh, const Groups& groups, const Divider& divider)
      : mesh_(mesh), groups_(groups), divider_(divider), vertex_(mesh.nodes.size(), -1) {
    result_.patches.resize(groups.boundary_names.size());
  }

  void add(DividedGrid&& d) {
    PlateBlock block{{}, groups_.block2region[d.grid.block], {}};
    for (int k = 0; k < 4; ++k) block.corners[k] = vertex_at(d.corners()[k]);
    for (int k = 0; k < 4; ++k) add_side(block.corners[k], block.corners[(k + 1) % 4], d, k);
    for (std::size_t k = 0; k < d.points.size(); ++k)
      result_.moved = std::max(result_.moved, distance(d.points[k], mesh_.nodes[d.vertices[k]]));
    block.edges = std::move(d.edges);
    result_.blocks.push_back(std::move(block));
  }

  PlateBlocks collected() { return std::move(result_); }

 private:
  int vertex_at(int node) {
    if (vertex_[node] < 0) {
      vertex_[node] = static_cast<int>(result_.vertices.size());
      result_.vertices.push_back(node);
    }
    return vertex_[node];
  }

  void add_side(int from, int to, const DividedGrid& d, int k) {
    const DividedEdge& edge = d.edges[k];
    const bool is_first = known_.insert(std::minmax(from, to)).second;
    if (is_first && !edge.is_straight && edge.num_cells() > 1)  // the points of a single cell are its ends
      result_.splines.push_back({from, to, k < 2 ? edge.inner : edge.reversed().inner});
    const int boundary = divider_.boundary_of(d.grid.side(k).front());
    if (boundary >= 0) result_.patches[boundary].push_back({from, to});
  }

  const QuadMesh& mesh_;
  const Groups& groups_;
  const Divider& divider_;
  std::vector<int> vertex_;  ///< by mesh node; -1 none
  std::set<std::pair<int, int>> known_;
  PlateBlocks result_;
};

}  // namespace

PlateBlocks plate_blocks(const QuadMesh& mesh, const Groups& groups) {
  require_convex_cells(mesh, "OpenFOAM's cells");
  Divider divider(mesh, groups);
  std::vector<DividedGrid> grids = divider.divide();
  Collector collector(mesh, groups, divider);
  for (DividedGrid& grid : grids) collector.add(std::move(grid));
  return collector.collected();
}

}  // namespace quadrille::exports
