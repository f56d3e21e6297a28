#pragma once
// Options of the triangle mesh.

#include <vector>

#include "model/size_sources.hpp"

namespace quadrille::triangulate {

struct TriangulateOptions {
  int order = 8;             ///< shape order N, 1..16: proofs are exact to round-off up to degree 2N - 2 = 30
  double size = 0;           ///< greatest element size in file units; 0: diameter / 4
  double growth = 0.5;       ///< Lipschitz constant of the size field (0, 2]
  double curve_tol = 1e-12;  ///< greatest distance between element edges and curves, relative to the diameter
  int fan_layers = -1;       ///< layers of a corner fan; -1: chosen by the exponent at the corner
  double fan_factor = 0.15;  ///< ratio of the radii of successive layers (0, 1)
  /// Of the innermost layer, in diameters. Coordinates have 16 digits: curved elements of smaller ones are not valid
  /// for certain.
  double least_fan_radius = 1e-11;
  std::vector<SizePoint> size_points;  ///< greatest sizes at points, of callers alone; they grow from there
  void validate() const;               ///< throws UsageError
};

}  // namespace quadrille::triangulate
