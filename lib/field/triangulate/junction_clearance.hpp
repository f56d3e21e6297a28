#pragma once
// Clearance of a junction: its distance to the parts of the boundary that do not start there.

#include <vector>

#include "triangulate/outline.hpp"

namespace quadrille::triangulate {

class Clearance {
 public:
  /// Samples every piece such that its polyline turns by at most 10 degrees at a vertex.
  explicit Clearance(const Outline& outline);

  /// Distance from junction j to all pieces except those that end in its place (two, more at the end of a slit); of the
  /// two that meet at j, only the parts that approach the junction again count, and none of a piece that closes there.
  /// Infinite if there are no such parts.
  double at_junction(int j) const;

 private:
  bool ends_in(int piece, int place) const;
  bool is_closed(int piece) const;  ///< whether it ends where it starts

  const Outline* outline_;
  std::vector<std::vector<Vec2>> polylines_;  ///< by piece
};

}  // namespace quadrille::triangulate
