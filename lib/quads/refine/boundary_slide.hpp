#pragma once
// The vertices of a mesh on the boundary by their position along the loops of CAD curves, and whether they may slide.
//
// Fixed are vertices at joints between curves (corners and changes of name among them) and at breaks of a curve, and
// the ends of an edge that passes a joint, and all vertices on interfaces, which both regions share, and on periodic
// curves. The seam of a smooth closed curve fixes no vertex.

#include <vector>

#include "curve/chain.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::refine {

struct SlidingVertex {
  int node = 0;
  int loop = 0;
  double length = 0;  ///< along the loop from the start of its first curve
  bool is_fixed = false;
};

struct SlidingEdge {
  int elem = 0, side = 0;
  int from = 0, to = 0;  ///< vertices
};

class BoundarySlide {
 public:
  /// `mesh` must outlive it.
  explicit BoundarySlide(const QuadMesh& mesh);
  BoundarySlide(const BoundarySlide&) = delete;
  BoundarySlide& operator=(const BoundarySlide&) = delete;

  const std::vector<SlidingVertex>& vertices() const { return vertices_; }
  const std::vector<SlidingEdge>& edges() const { return edges_; }

  /// Position and unit tangent of a vertex that has slid by `slide`, a length along the loop.
  curve::ChainPoint at(int vertex, double slide) const;
  /// The N + 1 nodes of an edge whose ends have slid: the Gauss-Lobatto-Legendre points by arc length.
  std::vector<Vec2> edge_nodes(int edge, double slide_from, double slide_to) const;
  /// Distance of the edge's polynomial from the curve (refine/divide_arcs: interval_error).
  double edge_error(int edge, double slide_from, double slide_to) const;

 private:
  struct Ends {
    double low = 0, high = 0;  ///< fractions of the doubled loop, so that no edge passes its end
  };
  Ends ends_of(int edge, double slide_from, double slide_to) const;
  void add_loop(const std::vector<QuadBoundaryEdge>& loop_edges);
  double length_at(int loop, int curve, Vec2 x) const;
  void fix_at_breaks(int vertex);

  const QuadMesh* mesh_;
  std::vector<Nurbs> no_splines_;
  curve::CurveTable table_;
  std::vector<curve::Chain> loops_;  ///< each doubled: its curves twice in turn
  std::vector<double> curve_start_;  ///< length along its loop
  std::vector<SlidingVertex> vertices_;
  std::vector<SlidingEdge> edges_;
};

}  // namespace quadrille::refine
