#pragma once
// Heights over a plane at the points of a rectangular grid, in any order; between them a cubic spline in either
// direction (space_spline), with continuous second derivatives.

#include <string>
#include <vector>

#include "base/vec2.hpp"
#include "base/vec3.hpp"
#include "sweep/space_spline.hpp"

namespace quadrille::sweep {

class Terrain {
 public:
  /// Points (x, y, height). Throws UsageError, which names the `file`, unless they are a grid of at least 2 x 2.
  Terrain(const std::vector<Vec3>& points, std::string file);

  /// Throws UsageError outside the grid.
  double height(Vec2 x) const;

 private:
  std::string file_;
  std::vector<double> x_, y_;
  /// By point of the grid, x fastest: height, its slopes along x and y, and its mixed derivative.
  std::vector<double> z_, zx_, zy_, zxy_;
};

}  // namespace quadrille::sweep
