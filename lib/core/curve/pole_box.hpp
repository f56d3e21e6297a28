#pragma once
// The bounding box of the poles of curves, which contains the curves, and the whole line or circle on which one lies.

#include <optional>
#include <vector>

#include "base/vec2.hpp"
#include "model/cad_face.hpp"

namespace quadrille::curve {

struct PoleBox {
  Vec2 low, high;

  Vec2 centre() const { return 0.5 * (low + high); }
  double diagonal() const { return distance(low, high); }

  /// Widens the box so that it contains the other one.
  void extend(const PoleBox& other);

  /// Whether x lies in the box or at most `margin` (a length) outside each of its sides.
  bool contains(Vec2 x, double margin = 0) const {
    return low.x - margin <= x.x && x.x <= high.x + margin && low.y - margin <= x.y && x.y <= high.y + margin;
  }

  /// Whether the boxes have a common point, or are at most `margin` (a length) apart along both axes.
  bool meets(const PoleBox& other, double margin = 0) const {
    return low.x <= other.high.x + margin && other.low.x <= high.x + margin && low.y <= other.high.y + margin &&
           other.low.y <= high.y + margin;
  }

  /// The distance from x to the box: a lower bound of that to the curve.
  double distance_from(Vec2 x) const;
};

PoleBox pole_box(const Nurbs& curve);

/// `curves`: one at least.
PoleBox pole_box(const std::vector<Nurbs>& curves);

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
