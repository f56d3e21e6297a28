#pragma once
// A mesh to be relaxed: its movable vertices, the nodes that follow them, and the energy to minimise.
//
// The energy that relaxation minimises: the deviation of elements from their prescribed shape.
//
// At each node of an element, a = x_xi1 / l1 and b = x_xi2 / l2 are the derivatives of its map over their lengths in
// the mesh as it was, and mu = (|a|^2 + |b|^2) / (2 a x b) >= 1 is least where they are normal to each other and keep
// the proportion of the prescribed edge lengths; it has no bound where det J tends to 0 (Knupp 2001, shape metric with
// targets). The energy is the mean over nodes of mu^p, summed over elements: the power gives the worst elements the
// largest weight.

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <vector>

#include "model/quad_mesh.hpp"
#include "refine/boundary_slide.hpp"

namespace quadrille::refine {

/// Energy of one element, its gradient by the shifts of the corners and a positive definite part of the Hessian's
/// diagonal blocks (xx, xy, yy), when nodes follow corners bilinearly.
struct ElementEnergy {
  double value = 0;
  std::array<Vec2, 4> gradient;
  std::array<std::array<double, 3>, 4> hessian{};
};

class ShapeEnergy {
 public:
  /// Reference lengths are computed from the present `mesh`.
  explicit ShapeEnergy(const QuadMesh& mesh);

  /// Infinite if det J is not positive at a node.
  double value(int elem, const std::vector<Vec2>& nodes) const;
  ElementEnergy with_derivatives(int elem, const std::vector<Vec2>& nodes) const;

 private:
  struct Jacobians {
    Eigen::MatrixXd x1, x2, y1, y2;  ///< row: xi1, column: xi2
  };
  Jacobians jacobians(int elem, const std::vector<Vec2>& nodes) const;

  int order_;
  std::vector<int> elem_nodes_;
  Eigen::MatrixXd derivative_;
  std::vector<Vec2> inverse_lengths_;  ///< 1 / l1, 1 / l2 at each node of each element
};

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
  RelaxProblem(const QuadMesh& mesh, const std::vector<bool>& frozen_elems, SlidesOff slides_off = SlidesOff::nothing);
  RelaxProblem(const RelaxProblem&) = delete;
  RelaxProblem& operator=(const RelaxProblem&) = delete;

  const QuadMesh start;  ///< the mesh before; the others refer to it
  const BoundarySlide boundary;
  const NodeFollow follow;
  const ShapeEnergy energy;
  std::vector<bool> is_fixed;  ///< by vertex

  void fix_vertex(int vertex);
  /// Makes moves, or a gradient, of vertices that slide together the same.
  void join_twins(VertexMoves& moves) const;
  /// The first of the two vertices that slide together, in opposite directions, or the vertex itself.
  int slides_with(int vertex) const { return twin_[vertex] < 0 ? vertex : std::min(vertex, twin_[vertex]); }
  int num_vertices() const { return follow.num_vertices(); }
  /// Sum over all elements, for these nodes; infinite if det J is not positive.
  double total_energy(const std::vector<Vec2>& nodes) const;

 private:
  std::vector<int> twin_;  ///< by vertex: that with which it slides together, or -1
};

}  // namespace quadrille::refine
