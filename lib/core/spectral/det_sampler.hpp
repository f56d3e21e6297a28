#pragma once
// det J of quads and hexahedra at a tensor grid of points, where a program evaluates it.

#include <Eigen/Dense>
#include <vector>

#include "base/vec2.hpp"
#include "base/vec3.hpp"

namespace quadrille::spectral {

class DetSampler {
 public:
  /// Of elements of this order, at the grid of `points` in [-1,1] in each direction.
  DetSampler(int order, const std::vector<double>& points);

  /// det J with respect to [-1,1]^2, xi1 fastest; nodes as in model/quad_mesh.hpp. O(N^3) for as many points.
  std::vector<double> of_quad(const Vec2* nodes) const;

  /// det J with respect to [-1,1]^3, xi1 fastest, then xi2; nodes as in model/hex_mesh.hpp. O(N^4).
  std::vector<double> of_hex(const Vec3* nodes) const;

 private:
  Eigen::MatrixXd value_, slope_;  ///< row: point, column: node
};

}  // namespace quadrille::spectral
