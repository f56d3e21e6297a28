#pragma once
// Boxes around the poles of curves, which enclose the curves: cheap lower bounds of distances.

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::curve {

/// The smallest box with sides parallel to the axes that contains all poles of a curve.
struct PoleBox {
  explicit PoleBox(const Nurbs& curve);
  /// A lower bound of the distance from x to the curve.
  double distance_bound(Vec2 x) const;

  Vec2 low, high;
};

/// The boxes of several curves.
class PoleBoxes {
 public:
  explicit PoleBoxes(const std::vector<Nurbs>& curves) : boxes_(curves.begin(), curves.end()) {}
  double distance_bound(int curve, Vec2 x) const { return boxes_[curve].distance_bound(x); }

 private:
  std::vector<PoleBox> boxes_;
};

}  // namespace quadrille::curve
