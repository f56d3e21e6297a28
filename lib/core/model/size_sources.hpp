#pragma once
// Prescribed element sizes at points, in boxes and triangles (formats/size-field.md), or by a metric
// (formats/alignment.md).
//
// Lengths are in the unit of the file. Of a planar face positions are (x, y, 0), relative to face.origin; of a curved
// one they are those in space, in the coordinates of the CAD file.

#include <array>
#include <vector>

#include "base/vec2.hpp"
#include "base/vec3.hpp"
#include "model/alignment.hpp"

namespace quadrille {

/// A point of the plane z = 0.
constexpr Vec3 in_space(Vec2 x) { return {x.x, x.y, 0}; }

/// Edges of length `size` within `radius` of `position`, in the plane in which triangles are made.
struct SizePoint {
  Vec2 position;
  double size = 0;
  double radius = 0;
};

/// The same of a size field.
struct SizeBall {
  Vec3 position;
  double size = 0;
  double radius = 0;
};

/// Edges of length `size` in the rectangle, in space the cuboid, with sides along the axes.
struct SizeBox {
  Vec3 low, high;
  double size = 0;
};

/// Edges of a length that is linear between the sizes at the corners.
struct SizeTriangle {
  std::array<Vec3, 3> corners;
  std::array<double, 3> sizes{};
};

struct SizeSources {
  std::vector<SizeBall> points;
  std::vector<SizeBox> boxes;
  double growth = 0;  ///< size ratio of adjacent elements, > 1; 0: not prescribed
  std::vector<SizeTriangle> triangles = {};
  bool is_table = false;                  ///< scattered points, to be joined by triangles (triangulate/size_triangles)
  bool is_in_space = false;               ///< positions have three coordinates
  std::vector<MetricSample> metric = {};  ///< lengths that differ by direction, at scattered points
};

}  // namespace quadrille
