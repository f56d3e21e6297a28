#pragma once
// Size of a loop of curves: enclosed area and diameter.

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::outline {

/// The area enclosed by the closed chain of curves, positive if the chain is counter-clockwise.
double signed_area(const std::vector<Nurbs>& loop);

/// The largest distance between two points of the curves: sampled, then refined on the curves, so that it is invariant
/// under rotation.
double diameter(const std::vector<Nurbs>& loop);

struct PoleBox {
  Vec2 low, high;
  Vec2 centre() const { return 0.5 * (low + high); }
  double diagonal() const { return distance(low, high); }
  bool contains(Vec2 x) const { return low.x <= x.x && x.x <= high.x && low.y <= x.y && x.y <= high.y; }
};

/// The bounding box of the poles, which contains the curves.
PoleBox pole_box(const std::vector<Nurbs>& curves);

}  // namespace quadrille::outline
