#include "triangulate/boundary_segment.hpp"

#include <algorithm>
#include <limits>

#include "triangulate/junction_clearance.hpp"

namespace quadrille::triangulate {
namespace {

bool crosses(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const double c_side = cross(b - a, c - a), d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c), b_side = cross(d - c, b - c);
  return c_side * d_side < 0 && a_side * b_side < 0;
}

double polygon_distance(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (crosses(a, b, c, d)) return 0;
  return std::min({distance_to_segment(a, c, d), distance_to_segment(b, c, d), distance_to_segment(c, a, b),
                   distance_to_segment(d, a, b)});
}

}  // namespace

double segment_distance(const Segment& a, const Segment& b) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      least = std::min(least, polygon_distance(a.samples[i], a.samples[i + 1], b.samples[j], b.samples[j + 1]));
  return least;
}

}  // namespace quadrille::triangulate
