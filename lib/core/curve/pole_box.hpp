#pragma once
// The bounding box of the poles of curves, which contains the curves.

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

  /// The distance from x to the box: a lower bound of that to the curve.
  double distance_from(Vec2 x) const;
};

PoleBox pole_box(const Nurbs& curve);

/// `curves`: one at least.
PoleBox pole_box(const std::vector<Nurbs>& curves);

/// The box of each curve.
std::vector<PoleBox> pole_boxes(const std::vector<Nurbs>& curves);

}  // namespace quadrille::curve
