#pragma once
// A mesh to be relaxed: its movable vertices, the nodes that follow them, and the energy to minimise.
//
// Vertices on the boundary and on interfaces have a position along the loops of CAD curves, on which they slide. Fixed
// are those at joints between curves (corners and changes of name among them) and at breaks of a curve, the ends of an
// edge that passes a joint, and those where more than two regions meet. The seam of a smooth closed curve fixes no
// vertex. Vertices on periodic curves, and on both sides of an open slit, slide together.
//
// The energy that relaxation minimises: the deviation of elements from their prescribed shape.
//
// At each node of an element, a = x_xi1 / l1 and b = x_xi2 / l2 are the derivatives of its map over their lengths in
// the mesh as it was, and mu = (|a|^2 + |b|^2) / (2 a x b) >= 1 is least where they are normal to each other and keep
// the proportion of the prescribed edge lengths; it has no bound where det J tends to 0 (Knupp 2001, shape metric with
// targets). The energy is the mean over nodes of mu^p, summed over elements: the power gives the worst elements the
// largest weight.

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "curve/chain.hpp"
#include "model/interfaces.hpp"
#include "model/quad_mesh.hpp"

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

struct SlidingVertex {
  int node = 0;
  int loop = 0;
  double length = 0;  ///< along the loop from the start of its first curve
  bool is_fixed = false;
  bool is_at_break = false;  ///< of its curve
};

struct SlidingEdge {
  int elem = 0, side = 0;
  int from = 0, to = 0;  ///< vertices
};

class BoundarySlide {
 public:
  /// `mesh` must outlive it. `leaves_breaks`: vertices slide off breaks of curves and
  /// smooth joints between curves that have one name or none.
  explicit BoundarySlide(const QuadMesh& mesh, bool leaves_breaks = false);
  BoundarySlide(const BoundarySlide&) = delete;
  BoundarySlide& operator=(const BoundarySlide&) = delete;

  const std::vector<SlidingVertex>& vertices() const { return vertices_; }
  const std::vector<SlidingEdge>& edges() const { return edges_; }
  /// Pairs of vertices, on periodic curves or on both sides of an open slit, that slide together, in opposite
  /// directions.
  const std::vector<std::array<int, 2>>& twins() const { return twins_; }

  /// Position and unit tangent of a vertex that has slid by `slide`, a length along the loop.
  curve::ChainPoint at(int vertex, double slide) const;
  /// The curve at the middle of an edge whose ends have slid, and the parameter on it.
  PartnerPoint edge_middle(int edge, double slide_from, double slide_to) const;
  /// The N + 1 nodes of an edge whose ends have slid: the Gauss-Lobatto-Legendre points by arc length.
  std::vector<Vec2> edge_nodes(int edge, double slide_from, double slide_to) const;
  /// Distance of the edge's polynomial from the curve (sizing/interval_error).
  double edge_error(int edge, double slide_from, double slide_to) const;

 private:
  struct Ends {
    double low = 0, high = 0;  ///< fractions of the doubled loop, so that no edge passes its end
  };
  Ends ends_of(int edge, double slide_from, double slide_to) const;
  void add_loop(const std::vector<QuadBoundaryEdge>& loop_edges);
  double length_at(int loop, int curve, Vec2 x) const;
  void fix_at_breaks(int vertex);
  bool may_leave(const curve::Chain& chain, int joint) const;
  void fix_beside_joints(int edge);
  void add_twins(int curve, int twin, const std::vector<std::vector<int>>& curve_edges);

  const QuadMesh* mesh_;
  bool leaves_breaks_;
  std::vector<Nurbs> no_splines_;
  curve::CurveTable table_;
  std::vector<curve::Chain> loops_;  ///< each doubled: its curves twice in turn
  std::vector<double> curve_start_;  ///< length along its loop
  std::vector<SlidingVertex> vertices_;
  std::vector<SlidingEdge> edges_;
  std::vector<std::array<int, 2>> twins_;
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
  RelaxProblem(const QuadMesh& mesh, const std::vector<bool>& frozen_elems, bool leaves_breaks = false);
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
  int num_vertices() const { return follow.num_vertices(); }
  /// Sum over all elements, for these nodes; infinite if det J is not positive.
  double total_energy(const std::vector<Vec2>& nodes) const;

 private:
  std::vector<int> twin_;  ///< by vertex: that with which it slides together, or -1
};

}  // namespace quadrille::refine
