#pragma once
// The exact map of a block: transfinite (Gordon-Hall) blend of its four sides, each by its own arc-length fraction.

#include <array>

#include "curve/chain.hpp"

namespace quadrille {

class TransfiniteMap {
 public:
  /// Sides counter-clockwise, each walked counter-clockwise; the chains must outlive the map.
  explicit TransfiniteMap(const std::array<const Chain*, 4>& sides, const std::array<bool, 4>& backwards);

  /// The point at (s, t) in [0,1]^2: s along side 0, t along side 1. On a side the side's own point, exactly.
  Vec2 position(double s, double t) const;

 private:
  Vec2 side(int k, double fraction) const;  ///< fraction counted counter-clockwise
  std::array<const Chain*, 4> sides_;
  std::array<bool, 4> backwards_;
};

}  // namespace quadrille
