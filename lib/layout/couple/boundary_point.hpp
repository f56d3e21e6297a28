#pragma once
// Points of the boundaries of the regions of a face, and which of them are one point of the plane.
//
// A curve that two regions share is there twice (model/cad_face.hpp), so a point of it is two boundary points, one on
// each curve; a junction of three regions is three joints. Each boundary point is one sector about the point of the
// plane: the region that it bounds there.

#include <compare>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::couple {

/// Relative to the diameter: nodes on an interface or on periodic sides that are nearer than this are one.
inline constexpr double relative_same = 1e-8;

/// A point of a curve, not its end: that is the start of the next curve in the loop.
struct BoundaryPoint {
  int curve = 0;
  double t = 0;

  auto operator<=>(const BoundaryPoint&) const = default;
  bool is_joint(const CadFace& face) const { return t == face.curves[curve].begin(); }
  /// At a joint exactly that of the joint.
  Vec2 position(const CadFace& face) const;
};

/// The point with a parameter, which may be that of the curve's end.
BoundaryPoint boundary_point(const CadFace& face, int curve, double t);

/// The point of a loop that is nearest to a position; a joint within 1e-9 diameters of it.
BoundaryPoint nearest_boundary_point(const CadFace& face, int loop, Vec2 position);

/// The point on `partner` of a point of another curve: its partner across an interface, or its periodic image.
BoundaryPoint opposite_point(const CadFace& face, const BoundaryPoint& point, int partner);

/// All boundary points that are one point of the plane, counter-clockwise about it. If it is inside the whole, from the
/// lowest one on; if it is on the boundary of the whole, from the one whose outgoing curve is of that boundary on.
std::vector<BoundaryPoint> coincident_points(const CadFace& face, const BoundaryPoint& point);

/// Whether regions surround the point.
bool is_inside_whole(const CadFace& face, const BoundaryPoint& point);

}  // namespace quadrille::couple
