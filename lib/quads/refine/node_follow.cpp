#include "refine/node_follow.hpp"

#include "spectral/quadrature.hpp"

namespace quadrille::refine {

NodeFollow::NodeFollow(const QuadMesh& mesh, const BoundarySlide& boundary)
    : mesh_(&mesh), boundary_(&boundary), nodes_(mesh.nodes) {
  std::vector<int> node2vertex(mesh.nodes.size(), -1);
  const int n = mesh.order;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const std::array<int, 4> corners{node_of(elem, 0, 0), node_of(elem, n, 0), node_of(elem, n, n),
                                     node_of(elem, 0, n)};
    std::array<int, 4> vertices{};
    for (int c = 0; c < 4; ++c) {
      int& vertex = node2vertex[corners[c]];
      if (vertex < 0) {
        vertex = num_vertices();
        vertex_nodes_.push_back(corners[c]);
      }
      vertices[c] = vertex;
    }
    elem_vertices_.push_back(vertices);
  }
  on_boundary_.assign(vertex_nodes_.size(), -1);
  for (std::size_t b = 0; b < boundary.vertices().size(); ++b) {
    boundary2vertex_.push_back(node2vertex[boundary.vertices()[b].node]);
    on_boundary_[boundary2vertex_.back()] = static_cast<int>(b);
  }
}

int NodeFollow::node_of(int elem, int i, int j) const {
  return mesh_->elem_nodes[elem * mesh_->nodes_per_elem() + j * (mesh_->order + 1) + i];
}

std::vector<Vec2> NodeFollow::nodes(const VertexMoves& moves) const {
  std::vector<Vec2> shifts(nodes_.size());
  shift_sides(moves, shifts);
  for (int elem = 0; elem < mesh_->num_elems(); ++elem) shift_inside(elem, shifts);
  std::vector<Vec2> nodes = nodes_;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (shifts[i] != Vec2{}) nodes[i] += shifts[i];
  // Sums have rounding errors; the boundary's nodes must lie on their curves.
  for (std::size_t e = 0; e < boundary_->edges().size(); ++e) {
    const SlidingEdge& edge = boundary_->edges()[e];
    const double from = moves[boundary2vertex_[edge.from]].x, to = moves[boundary2vertex_[edge.to]].x;
    if (from == 0 && to == 0) continue;
    const std::vector<Vec2> on_curve = boundary_->edge_nodes(static_cast<int>(e), from, to);
    for (int k = 0; k <= mesh_->order; ++k)
      if ((k > 0 || from != 0) && (k < mesh_->order || to != 0)) nodes[side_node(edge, k)] = on_curve[k];
  }
  return nodes;
}

int NodeFollow::side_node(const SlidingEdge& edge, int k) const {
  const int n = mesh_->order;
  const std::array<std::array<int, 2>, 4> grid_positions{{{k, 0}, {n, k}, {n - k, n}, {0, n - k}}};
  return node_of(edge.elem, grid_positions[edge.side][0], grid_positions[edge.side][1]);
}

void NodeFollow::shift_sides(const VertexMoves& moves, std::vector<Vec2>& shifts) const {
  for (int v = 0; v < num_vertices(); ++v) {
    const int b = on_boundary_[v];
    if (moves[v] == Vec2{}) continue;
    shifts[vertex_nodes_[v]] = b < 0 ? moves[v] : boundary_->at(b, moves[v].x).position - nodes_[vertex_nodes_[v]];
  }
  const std::vector<double>& xi = spectral::gll_points(mesh_->order);
  for (int elem = 0; elem < mesh_->num_elems(); ++elem)
    for (int side = 0; side < 4; ++side) {
      const SlidingEdge edge{elem, side, 0, 0};
      const Vec2 from = shifts[side_node(edge, 0)], to = shifts[side_node(edge, mesh_->order)];
      for (int k = 1; k < mesh_->order; ++k) shifts[side_node(edge, k)] = (1 - xi[k]) / 2 * from + (1 + xi[k]) / 2 * to;
    }
  for (std::size_t e = 0; e < boundary_->edges().size(); ++e) {
    const SlidingEdge& edge = boundary_->edges()[e];
    const double from = moves[boundary2vertex_[edge.from]].x, to = moves[boundary2vertex_[edge.to]].x;
    if (from == 0 && to == 0) continue;
    const std::vector<Vec2> on_curve = boundary_->edge_nodes(static_cast<int>(e), from, to);
    for (int k = 1; k < mesh_->order; ++k) shifts[side_node(edge, k)] = on_curve[k] - nodes_[side_node(edge, k)];
  }
}

/// Gordon-Hall blend of the shifts on the sides.
void NodeFollow::shift_inside(int elem, std::vector<Vec2>& shifts) const {
  const int n = mesh_->order;
  const std::vector<double>& xi = spectral::gll_points(n);
  const auto at = [&](int i, int j) { return shifts[node_of(elem, i, j)]; };
  const std::array<Vec2, 4> corner{at(0, 0), at(n, 0), at(n, n), at(0, n)};
  bool is_moved = false;
  for (const Vec2 c : corner) is_moved |= c != Vec2{};
  if (!is_moved) return;
  for (int j = 1; j < n; ++j)
    for (int i = 1; i < n; ++i) {
      const double s = (1 + xi[i]) / 2, t = (1 + xi[j]) / 2;
      shifts[node_of(elem, i, j)] =
          (1 - t) * at(i, 0) + t * at(i, n) + (1 - s) * at(0, j) + s * at(n, j) -
          ((1 - s) * (1 - t) * corner[0] + s * (1 - t) * corner[1] + s * t * corner[2] + (1 - s) * t * corner[3]);
    }
}

}  // namespace quadrille::refine
