#pragma once
// A mesh to be relaxed: its movable vertices, and the nodes that follow them.

#include <algorithm>
#include <array>
#include <vector>

#include "model/quad_mesh.hpp"
#include "refine/boundary_slide.hpp"

namespace quadrille::refine {

/// The move of a vertex from its first position: on the boundary (slide, 0), a length along the loop; inside a shift.
using VertexMoves = std::vector<Vec2>;

/// The positions of all nodes of a mesh whose vertices move.
class NodeFollow {
 public:
  /// `mesh` and `boundary` must outlive it; nodes are copied, later changes of the mesh have no effect.
  NodeFollow(const QuadMesh& mesh, const BoundarySlide& boundary);

  int num_vertices() const { return static_cast<int>(vertex_nodes_.size()); }
  /// The vertices at the corners of each element.
  const std::vector<std::array<int, 4>>& elem_vertices() const { return elem_vertices_; }
  /// The number of a vertex among the boundary vertices, -1 inside.
  int on_boundary(int vertex) const { return on_boundary_[vertex]; }
  /// The vertex of a boundary vertex. That of an interface is one of both regions.
  int vertex_of(int boundary_vertex) const { return boundary2vertex_[boundary_vertex]; }
  /// The direction along its loop in which a boundary vertex slides: -1 if its vertex slides along the other region's.
  int direction(int boundary_vertex) const {
    return on_boundary_[vertex_of(boundary_vertex)] == boundary_vertex ? 1 : -1;
  }
  /// The slide of a boundary vertex along its loop.
  double slide(int boundary_vertex, const VertexMoves& moves) const {
    return direction(boundary_vertex) * moves[vertex_of(boundary_vertex)].x;
  }

  /// All nodes. Nodes of elements whose vertices do not move keep their position bit for bit.
  std::vector<Vec2> nodes(const VertexMoves& moves) const;

 private:
  void shift_sides(const VertexMoves& moves, std::vector<Vec2>& shifts) const;
  void shift_inside(int elem, std::vector<Vec2>& shifts) const;
  int node_of(int elem, int i, int j) const;
  int edge_node(const SlidingEdge& edge, int k) const;  ///< k = 0..N along the edge
  /// visit(edge, slide of its start, of its end, its nodes on the curve) for edges whose ends have slid.
  template <class Visit>
  void for_moved_edges(const VertexMoves& moves, const Visit& visit) const;

  const QuadMesh* mesh_;
  const BoundarySlide* boundary_;
  std::vector<Vec2> nodes_;
  std::vector<int> vertex_nodes_, on_boundary_, boundary2vertex_;
  std::vector<std::array<int, 4>> elem_vertices_;
};

/// The data that do not change during the relaxation.
struct RelaxProblem {
  /// `frozen_elems` by element: keeps all nodes; empty: none does.
  RelaxProblem(const QuadMesh& mesh, const std::vector<bool>& frozen_elems, SlidesOff slides_off = SlidesOff::breaks);
  RelaxProblem(const RelaxProblem&) = delete;
  RelaxProblem& operator=(const RelaxProblem&) = delete;

  const QuadMesh start;  ///< the mesh before; the others refer to it
  const BoundarySlide boundary;
  const NodeFollow follow;
  std::vector<bool> is_fixed;  ///< by vertex

  void fix_vertex(int vertex);
  /// Makes moves, or a gradient, of vertices that slide together the same.
  void join_twins(VertexMoves& moves) const;
  /// That with which a vertex slides together, in opposite directions, or -1.
  int twin(int vertex) const { return twin_[vertex]; }
  /// The first of the two vertices that slide together, in opposite directions, or the vertex itself.
  int slides_with(int vertex) const { return twin_[vertex] < 0 ? vertex : std::min(vertex, twin_[vertex]); }
  int num_vertices() const { return follow.num_vertices(); }

 private:
  std::vector<int> twin_;
};

}  // namespace quadrille::refine
