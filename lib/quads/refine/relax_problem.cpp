#include "refine/relax_problem.hpp"

#include <algorithm>

#include "mesh/transfinite.hpp"
#include "model/quad_mesh.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::refine {
NodeFollow::NodeFollow(const QuadMesh& mesh, const BoundarySlide& boundary)
    : mesh_(&mesh), boundary_(&boundary), nodes_(mesh.nodes) {
  std::vector<int> node2vertex(mesh.nodes.size(), -1);
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    std::array<int, 4> vertices{};
    for (int c = 0; c < 4; ++c) {
      const int node = side_start(mesh, elem, c);
      if (node2vertex[node] < 0) {
        node2vertex[node] = num_vertices();
        vertex_nodes_.push_back(node);
      }
      vertices[c] = node2vertex[node];
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
  for_moved_edges(moves, [&](const SlidingEdge& edge, double from, double to, const std::vector<Vec2>& on_curve) {
    for (int k = 0; k <= mesh_->order; ++k)
      if ((k > 0 || from != 0) && (k < mesh_->order || to != 0)) nodes[edge_node(edge, k)] = on_curve[k];
  });
  return nodes;
}

int NodeFollow::edge_node(const SlidingEdge& edge, int k) const { return side_node(*mesh_, edge.elem, edge.side, k); }

template <class Visit>
void NodeFollow::for_moved_edges(const VertexMoves& moves, const Visit& visit) const {
  for (std::size_t e = 0; e < boundary_->edges().size(); ++e) {
    const SlidingEdge& edge = boundary_->edges()[e];
    const double from = slide(edge.from, moves), to = slide(edge.to, moves);
    if (from != 0 || to != 0) visit(edge, from, to, boundary_->edge_nodes(static_cast<int>(e), from, to));
  }
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
      const std::vector<int> nodes = side_nodes(*mesh_, elem, side);
      const Vec2 from = shifts[nodes.front()], to = shifts[nodes.back()];
      for (int k = 1; k < mesh_->order; ++k) shifts[nodes[k]] = (1 - xi[k]) / 2 * from + (1 + xi[k]) / 2 * to;
    }
  for_moved_edges(moves, [&](const SlidingEdge& edge, double, double, const std::vector<Vec2>& on_curve) {
    for (int k = 1; k < mesh_->order; ++k) shifts[edge_node(edge, k)] = on_curve[k] - nodes_[edge_node(edge, k)];
  });
}

/// Gordon-Hall blend of the shifts on the sides.
void NodeFollow::shift_inside(int elem, std::vector<Vec2>& shifts) const {
  const int n = mesh_->order;
  const std::vector<double>& xi = spectral::gll_points(n);
  const auto at = [&](int i, int j) { return shifts[node_of(elem, i, j)]; };
  const std::array<Vec2, 4> corner{at(0, 0), at(n, 0), at(n, n), at(0, n)};
  if (std::ranges::count(corner, Vec2{}) == 4) return;
  for (int j = 1; j < n; ++j)
    for (int i = 1; i < n; ++i) {
      shifts[node_of(elem, i, j)] =
          mesh::blend_sides({at(i, 0), at(n, j), at(i, n), at(0, j)}, corner, (1 + xi[i]) / 2, (1 + xi[j]) / 2);
    }
}

RelaxProblem::RelaxProblem(const QuadMesh& mesh, const std::vector<bool>& frozen_elems, SlidesOff slides_off)
    : start(mesh),
      boundary(start, slides_off),
      follow(start, boundary),
      is_fixed(follow.num_vertices(), false),
      twin_(follow.num_vertices(), -1) {
  for (const auto& [a, b] : boundary.twins()) {
    twin_[follow.vertex_of(a)] = follow.vertex_of(b);
    twin_[follow.vertex_of(b)] = follow.vertex_of(a);
  }
  std::vector<int> num_loops(num_vertices(), 0);
  for (std::size_t b = 0; b < boundary.vertices().size(); ++b) {
    const int v = follow.vertex_of(static_cast<int>(b));
    if (boundary.vertices()[b].is_fixed || ++num_loops[v] > 2) fix_vertex(v);
  }
  for (std::size_t elem = 0; elem < frozen_elems.size(); ++elem)
    if (frozen_elems[elem])
      for (const int v : follow.elem_vertices()[elem]) fix_vertex(v);
}

void RelaxProblem::fix_vertex(int vertex) {
  is_fixed[vertex] = true;
  if (twin_[vertex] >= 0) is_fixed[twin_[vertex]] = true;
}

void RelaxProblem::join_twins(VertexMoves& moves) const {
  for (int v = 0; v < num_vertices(); ++v) {
    if (twin_[v] <= v) continue;
    const double slide = (moves[v].x - moves[twin_[v]].x) / 2;
    moves[v].x = slide, moves[twin_[v]].x = -slide;
  }
}

}  // namespace quadrille::refine
