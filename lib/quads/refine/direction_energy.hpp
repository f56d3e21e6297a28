#pragma once
// What prescribed directions add to the size energy at one point of an element (refine/size_energy).

#include <Eigen/Dense>

#include "base/vec2.hpp"

namespace quadrille::refine {

/// For the deviation of a = x_s / h from a prescribed cross: |c| - Re(conj(c) (a / |a|)^4), c =
/// `target` as a complex number: 0 along the cross, 2 |c| at 45 degrees from it.
struct DirectionEnergy {
  DirectionEnergy(Vec2 a, Vec2 target);
  double value;
  Vec2 by_a;
  double bend;  ///< second derivative by the angle of a, which changes with a by `turn`
  Vec2 turn;
};

/// The second derivatives by a.
Eigen::Matrix2d direction_bend(Vec2 a, Vec2 target);

/// The derivative of the angle of a by a, times the root of the second derivative by the angle.
Vec2 root_of_direction_bend(Vec2 a, Vec2 target);

}  // namespace quadrille::refine
