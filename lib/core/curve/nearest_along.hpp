#pragma once
// Points of a mesh's boundary edges on the curves that the edges follow.

#include "curve/face_boundary.hpp"

namespace quadrille::curve {

/// The nearest point of a curve and of its two neighbours in the loop: an edge of a mesh on the curve may pass a joint.
inline NearestPoint nearest_along(const FaceBoundary& boundary, int curve, Vec2 x) {
  const CadFace& face = boundary.face();
  const int before = face.previous_in_loop(curve), after = face.next_in_loop(curve);
  return boundary.nearest(x, [&](int c) { return c == curve || c == before || c == after; });
}

}  // namespace quadrille::curve
