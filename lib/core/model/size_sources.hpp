#pragma once
// Prescribed element sizes at points, in boxes and triangles (formats/size-field.md), or by a metric
// (formats/alignment.md).
//
// Positions are relative to face.origin, lengths in the unit of the file.

#include <array>
#include <vector>

#include "base/vec2.hpp"
#include "model/alignment.hpp"

namespace quadrille {

/// Edges of length `size` within `radius` of `position`.
struct SizePoint {
  Vec2 position;
  double size = 0;
  double radius = 0;
};

/// Edges of length `size` in the rectangle with sides along the axes.
struct SizeBox {
  Vec2 low, high;
  double size = 0;
};

/// Edges of a length that is linear between the sizes at the corners.
struct SizeTriangle {
  std::array<Vec2, 3> corners;
  std::array<double, 3> sizes{};
};

struct SizeSources {
  std::vector<SizePoint> points;
  std::vector<SizeBox> boxes;
  double growth = 0;  ///< size ratio of adjacent elements, > 1; 0: not prescribed
  std::vector<SizeTriangle> triangles = {};
  bool is_table = false;                  ///< scattered points, to be joined by triangles (triangulate/size_triangles)
  std::vector<MetricSample> metric = {};  ///< lengths that differ by direction, at scattered points
};

}  // namespace quadrille
