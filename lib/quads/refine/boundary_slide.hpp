#pragma once
// Vertices on the boundary and on interfaces have a position along the loops of CAD curves, on which they slide. Fixed
// are those at joints between curves (corners and changes of name among them) and at breaks of a curve, unless they may
// slide off (SlidesOff), the ends of an edge that passes a joint, and those where more than two regions meet. The seam
// of a smooth closed curve fixes no vertex. Vertices on periodic curves, and on both sides of an open slit, slide
// together.

#include <array>
#include <vector>

#include "curve/chain.hpp"
#include "model/interfaces.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::refine {

/// What vertices may slide off.
enum class SlidesOff {
  breaks,  ///< of curves, and smooth joints between curves of one name
  joints,  ///< also, on loops without interfaces and periodic curves, smooth joints between curves without given names
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

/// A joint of a loop.
struct LoopJoint {
  int loop = 0;
  double length = 0;  ///< along the loop from the start of its first curve, less than its length
};

class BoundarySlide {
 public:
  /// `mesh` must outlive it.
  explicit BoundarySlide(const QuadMesh& mesh, SlidesOff slides_off = SlidesOff::breaks);
  BoundarySlide(const BoundarySlide&) = delete;
  BoundarySlide& operator=(const BoundarySlide&) = delete;

  const std::vector<SlidingVertex>& vertices() const { return vertices_; }
  const std::vector<SlidingEdge>& edges() const { return edges_; }
  /// Joints between curves of different names that vertices may slide off.
  const std::vector<LoopJoint>& free_joints() const { return free_joints_; }
  double loop_length(int loop) const { return loops_[loop].length() / 2; }
  /// The length along its loop at which a curve starts, and its own.
  double curve_start(int curve) const { return curve_start_[curve]; }
  double curve_length(int curve) const { return table_.arc_length(curve).total(); }
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
  bool passes_free_joint(int edge, double slide_from, double slide_to) const;
  /// The error of an edge between two lengths along a loop, `from` < `to`.
  double error_between(int loop, double from, double to) const;

 private:
  struct Ends {
    double low = 0, high = 0;  ///< fractions of the doubled loop, so that no edge passes its end
  };
  Ends ends_of(int edge, double slide_from, double slide_to) const;
  void add_loop(const std::vector<QuadBoundaryEdge>& loop_edges);
  double length_at(int loop, int curve, Vec2 x) const;
  void fix_at_breaks(int vertex);
  bool may_leave(const curve::Chain& chain, int joint) const;
  void find_free_joints(int loop);
  void fix_beside_joints(int edge);
  void add_twins(int curve, int twin, const std::vector<std::vector<int>>& curve_edges);

  const QuadMesh* mesh_;
  SlidesOff slides_off_;
  std::vector<Nurbs> no_splines_;
  curve::CurveTable table_;
  std::vector<curve::Chain> loops_;  ///< each doubled: its curves twice in turn
  std::vector<double> curve_start_;  ///< length along its loop
  std::vector<bool> is_loop_shared_;
  std::vector<LoopJoint> free_joints_;
  std::vector<SlidingVertex> vertices_;
  std::vector<SlidingEdge> edges_;
  std::vector<std::array<int, 2>> twins_;
};

}  // namespace quadrille::refine
