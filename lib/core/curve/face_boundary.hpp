#pragma once
// The boundary of a face: nearest points, signed distances, visibility and rays. A search tree over the knot spans of
// the curves is built once, in O(n log n) for n spans; a query costs O(log n). Nearest points are those of a loop over
// all curves with curve::project, bit for bit.

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "curve/pole_box.hpp"
#include "model/cad_face.hpp"

namespace quadrille::curve {

/// The point of one curve nearest to a given point of the plane.
struct NearestPoint {
  int curve = -1;  ///< its number in the tree; -1: no curve was found
  double t = 0;
  Vec2 position;
  double distance = HUGE_VAL;
};

/// Where a ray crosses a curve.
struct RayHit {
  int curve = 0;
  double t = 0;
  double length = 0;     ///< along the ray, in lengths of its direction
  bool to_left = false;  ///< the curve crosses the ray from the right to the left
};

struct FarthestPoint {
  double distance = 0;
  Vec2 position;
};

/// Any curves with positive weights, numbered in their order. They must outlive the tree and stay where they are.
class CurveTree {
 public:
  /// Whether a curve is looked at; an empty function: all are.
  using Filter = std::function<bool(int curve)>;

  /// `items`: curves, or what std::invoke(curve_of, item) makes curves of: a pointer to a member, a function.
  template <class Items, class Projection = std::identity>
  explicit CurveTree(const Items& items, Projection curve_of = {}) {
    for (const auto& item : items) curves_.push_back(&std::invoke(curve_of, item));
    build();
  }

  /// The nearest point; the lowest number of several curves that are equally near, exactly.
  NearestPoint nearest(Vec2 x, const Filter& filter = {}) const;
  /// One foot on each curve whose distance is at most `tol` above the least one, ascending by curve.
  std::vector<NearestPoint> nearest_feet(Vec2 x, double tol, const Filter& filter = {}) const;
  /// One foot on each curve whose distance is at most `reach`, ascending by curve.
  std::vector<NearestPoint> feet_within(Vec2 x, double reach, const Filter& filter = {}) const;
  /// Calls visit(foot, reach) for each curve that may be at most `reach` away, near ones first. `visit` may lower the
  /// reach.
  void visit_feet(Vec2 x, double reach, const std::function<void(const NearestPoint&, double&)>& visit,
                  const Filter& filter = {}) const;

  /// The first point at which a curve crosses the ray from x, or nothing up to the length `reach`. A curve that touches
  /// the ray crosses it twice or not at all.
  std::optional<RayHit> first_hit(Vec2 x, Vec2 direction, double reach = HUGE_VAL) const;
  /// All of them, ascending by length.
  std::vector<RayHit> hits(Vec2 x, Vec2 direction, double reach = HUGE_VAL) const;
  /// How often the curves, closed loops, wind around x, which lies on none of them: positive if counter-clockwise.
  int winding_number(Vec2 x) const;

  /// The point with the largest distance from the nearest curve; no curve: distance 0. Fastest if neighbours in
  /// `points` are near each other: the cost of a point is then that of a few Newton steps.
  FarthestPoint farthest(const std::vector<Vec2>& points) const;

 private:
  /// A knot span with the box around its poles, which contains it.
  struct Span {
    int curve = 0;
    double t0 = 0, t1 = 0;
    PoleBox box;
  };
  /// Of a binary tree: the first child follows its parent.
  struct Node {
    PoleBox box;
    int second = -1;  ///< child; -1: a leaf
    int span = -1;    ///< of a leaf
  };
  /// A parameter near the nearest point.
  struct Guess {
    int curve = 0;
    double t = 0;
  };

  void build();
  void add_spans(int curve);
  void add_nodes(int first, int last);
  template <class Bound, class Visit>
  void visit_spans(const Bound& bound, double& reach, const Visit& visit) const;
  void visit_hits(Vec2 x, Vec2 direction, double& reach, const std::function<void(const RayHit&)>& visit) const;
  double improve(Vec2 x, double known, Guess& guess) const;
  double distance_above(Vec2 x, double known, Guess& guess) const;

  std::vector<const Nurbs*> curves_;
  std::vector<Span> spans_;
  std::vector<Node> nodes_;
  double rounding_ = 0;  ///< of positions, a length: a computed point may lie as far outside its box
};

/// The curves of a face, which must outlive the object, with their sides. The face may have several regions.
class FaceBoundary : public CurveTree {
 public:
  explicit FaceBoundary(const CadFace& face) : CurveTree(face.curves), face_(&face) {}

  const CadFace& face() const { return *face_; }
  /// Distance to the boundary, negative outside the face; both sides of a slit are inside.
  double signed_distance(Vec2 x) const;
  bool contains(Vec2 x) const { return signed_distance(x) > 0; }
  /// Whether the segment between two points inside the face lies inside, 1e-9 diameters off the boundary.
  bool is_visible(Vec2 from, Vec2 to) const;
  /// Length of the first part of a ray that lies inside the face; 0 if the ray lies outside. `direction`: a unit
  /// vector.
  double length_inside(Vec2 x, Vec2 direction) const;

 private:
  const CadFace* face_;
};

/// The mean width of a face: twice the area over the length of the boundary, the width of a long strip.
double mean_width(const CadFace& face);

}  // namespace quadrille::curve
