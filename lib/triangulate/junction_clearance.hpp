#pragma once
// Clearance of a junction: its distance to the parts of the boundary that do not start there.

#include <vector>

#include "triangulate/outline.hpp"

namespace quadrille::triangulate {

class Clearance {
 public:
  /// Samples every piece such that its polyline turns by at most 10 degrees at a vertex.
  explicit Clearance(const Outline& outline);

  /// Distance from junction j to all pieces except the two that meet there; of these two, only the parts that approach
  /// the junction again count. Infinite if there are no such parts.
  double at_junction(int j) const;

 private:
  const Outline* outline_;
  std::vector<std::vector<Vec2>> polylines_;  ///< by piece
};

}  // namespace quadrille::triangulate
