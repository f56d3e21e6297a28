#pragma once
// The size energy at one point of an element (refine/size_energy), and where the points of elements are.

#include <Eigen/Dense>
#include <array>

#include "base/vec2.hpp"

namespace quadrille::refine {

/// The energy for a = x_s / h and b = x_t / h, and its derivatives by these; infinite if det J is not positive.
struct PointEnergy {
  PointEnergy(Vec2 a, Vec2 b, double weight);
  double value = 0;
  Vec2 by_a, by_b;
  /// Of the second derivatives: of mu^3 by mu and of mu by a and b; factors of the unit matrix, and of a a and b b.
  double mu_slope = 0, mu_bend = 0, size_a = 0, size_b = 0, turn_a = 0, turn_b = 0;
  Vec2 mu_a, mu_b;
};

/// The second derivatives by (a, b), with the absolute values of its curvatures: positive semidefinite.
Eigen::Matrix4d point_hessian(Vec2 a, Vec2 b, double weight);

struct SidePoint {
  int point = 0;  ///< s fastest
  bool is_along_a = true;
  double along = 1, across = 1;  ///< signs of the derivatives along the side and away from it
};

/// Of n x n points of an element: point p along a side, r away from it.
SidePoint side_point(int side, int p, int r, int n);

/// Derivatives by s and t of the bilinear functions of the corners.
std::array<Vec2, 4> corner_slopes(double s, double t);

}  // namespace quadrille::refine
