#pragma once
// The positions of all nodes of a mesh whose vertices move (refine/relax).

#include <array>
#include <vector>

#include "refine/boundary_slide.hpp"

namespace quadrille::refine {

/// The move of a vertex from its first position: on the boundary (slide, 0), a length along the loop; inside a shift.
using VertexMoves = std::vector<Vec2>;

class NodeFollow {
 public:
  /// `mesh` and `boundary` must outlive it; nodes are copied, later changes of the mesh have no effect.
  NodeFollow(const QuadMesh& mesh, const BoundarySlide& boundary);

  int num_vertices() const { return static_cast<int>(vertex_nodes_.size()); }
  /// The vertices at the corners of each element.
  const std::vector<std::array<int, 4>>& elem_vertices() const { return elem_vertices_; }
  /// The number of a vertex among the boundary vertices, -1 inside.
  int on_boundary(int vertex) const { return on_boundary_[vertex]; }
  /// The vertex of a boundary vertex.
  int vertex_of(int boundary_vertex) const { return boundary2vertex_[boundary_vertex]; }

  /// All nodes. Nodes of elements whose vertices do not move keep their position bit for bit.
  std::vector<Vec2> nodes(const VertexMoves& moves) const;

 private:
  void shift_sides(const VertexMoves& moves, std::vector<Vec2>& shifts) const;
  void shift_inside(int elem, std::vector<Vec2>& shifts) const;
  int node_of(int elem, int i, int j) const;
  int side_node(const SlidingEdge& edge, int k) const;  ///< k = 0..N along the side

  const QuadMesh* mesh_;
  const BoundarySlide* boundary_;
  std::vector<Vec2> nodes_;
  std::vector<int> vertex_nodes_, on_boundary_, boundary2vertex_;
  std::vector<std::array<int, 4>> elem_vertices_;
};

}  // namespace quadrille::refine
