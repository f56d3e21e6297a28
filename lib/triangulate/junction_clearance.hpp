#pragma once
// How far a junction is from the parts of the boundary that do not start there.

#include <vector>

#include "triangulate/outline.hpp"

namespace quadrille::triangulate {

class Clearance {
 public:
  /// Samples every piece so that its polygon turns by at most 10 degrees at a vertex.
  explicit Clearance(const Outline& outline);

  /// Distance from junction j to all pieces but the two that meet there; of those the parts count from where they
  /// begin to come back. Infinite where there is nothing.
  double at_junction(int j) const;

 private:
  const Outline* outline_;
  std::vector<std::vector<Vec2>> polylines_;  ///< by piece
};

}  // namespace quadrille::triangulate
