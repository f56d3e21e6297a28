#pragma once
// A segment of the boundary of the domain without the corner fans.

#include <array>

#include "base/vec2.hpp"

namespace quadrille::triangulate {

struct Segment {
  int from = 0, to = 0;  ///< vertices of the draft; the face on the left
  int curve = -1;        ///< -1: rim of a fan
  double t0 = 0, t1 = 0;
  double s0 = 0, s1 = 0;        ///< arc length on the curve
  std::array<Vec2, 5> samples;  ///< on the curve at quarters of the arc length, ends included
  Vec2 centre;                  ///< of a circle that contains the samples
  double radius = 0;

  bool is_rim() const { return curve < 0; }
  double length() const { return s1 - s0; }
};

/// Least distance between the polylines through the samples of two segments.
double segment_distance(const Segment& a, const Segment& b);

}  // namespace quadrille::triangulate
