#pragma once
// The whole line or circle on which a curve lies, and intersections of these.

#include <optional>

#include "model/cad_face.hpp"

namespace quadrille::curve {

enum class CurveKind { spline, arc, line };

struct Carrier {
  CurveKind kind = CurveKind::spline;
  Vec2 point;         ///< a point of the line, or the centre of the circle
  Vec2 direction;     ///< of the line, a unit vector
  double radius = 0;  ///< of the circle
};

/// A curve of degree 1 with two poles lies on a line; a rational quadratic one lies on a circle if the quarters of
/// its spans do, within 1e-9 of the radius; any other is a spline.
Carrier carrier_of(const Nurbs& curve);

/// The point of the line or circle nearest to x; x itself for a spline.
Vec2 nearest_on(const Carrier& carrier, Vec2 x);

/// The intersection of two lines or circles nearest to `x`; std::nullopt if the carriers do not intersect or one of
/// them is a spline.
std::optional<Vec2> intersection(const Carrier& a, const Carrier& b, Vec2 x);

}  // namespace quadrille::curve
