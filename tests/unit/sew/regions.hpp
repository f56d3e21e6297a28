#pragma once
// Regions made by hand, for the tests of this folder.

#include <string>
#include <vector>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "sew/region.hpp"

namespace quadrille::testing_regions {

using heal::Loop;

inline Loop polygon(const std::vector<Vec2>& points) {
  Loop loop;
  for (std::size_t i = 0; i < points.size(); ++i)
    loop.push_back({curve::segment(points[i], points[(i + 1) % points.size()]), static_cast<int>(i), ""});
  return loop;
}

inline Loop rectangle(Vec2 low, Vec2 high) { return polygon({low, {high.x, low.y}, high, {low.x, high.y}}); }

inline Loop closed(Nurbs curve) {
  curve.poles.back() = curve.poles.front();
  return {{curve, 0, ""}};
}

/// Counter-clockwise; the seam at this angle, radians.
inline Loop circle(Vec2 centre, double radius, double seam = 0) {
  return closed(curve::circular_arc(centre, radius, seam, seam + 2 * pi));
}
inline Loop hole(Vec2 centre, double radius, double seam = 0) {
  return closed(curve::circular_arc(centre, radius, seam + 2 * pi, seam));
}

/// Named "region 0" and so on, of faces 0, 1, ...
inline std::vector<sew::Region> regions_of(const std::vector<std::vector<Loop>>& faces) {
  std::vector<sew::Region> regions;
  for (std::size_t f = 0; f < faces.size(); ++f)
    regions.push_back(sew::region_of(faces[f], "part" + std::to_string(f), static_cast<int>(f)));
  return regions;
}

}  // namespace quadrille::testing_regions
