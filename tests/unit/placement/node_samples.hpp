#pragma once
// Irregular nodes for the tests of their placement.

#include <vector>

#include "model/critical_points.hpp"

namespace quadrille::placement {

/// One node of this valence at each position.
inline CriticalPoints points_at(const std::vector<Vec2>& positions, int valence = 3) {
  CriticalPoints points;
  for (const Vec2 x : positions) {
    CriticalPoint p;
    p.position = x;
    p.valence = valence;
    p.index = 4 - valence;
    points.critical_points.push_back(p);
  }
  return points;
}

}  // namespace quadrille::placement
