#pragma once
// Boxes around the poles of curves, which enclose the curves: cheap lower bounds of distances.

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::curve {

class PoleBoxes {
 public:
  explicit PoleBoxes(const std::vector<Nurbs>& curves);
  /// A lower bound of the distance from x to the curve.
  double distance_bound(int curve, Vec2 x) const;

 private:
  struct Box {
    Vec2 low, high;
  };
  std::vector<Box> boxes_;  ///< by curve
};

}  // namespace quadrille::curve
