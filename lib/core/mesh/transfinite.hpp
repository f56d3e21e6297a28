#pragma once
// The exact map of a block: transfinite (Gordon-Hall) blend of its four sides, each by its own arc-length fraction.

#include <array>
#include <vector>

#include "curve/chain.hpp"

namespace quadrille::mesh {

/// Gordon-Hall blend at (s, t) in [0,1]^2. `on_sides`: the points at s on side 0, at t on side 1, at s on side 2 (above
/// that on side 0) and at t on side 3. `corners` counter-clockwise; corner 0 is at (0, 0). On a side, i.e. if s or t is
/// exactly 0 or 1, the result is the side's own point, without rounding.
Vec2 blend_sides(const std::array<Vec2, 4>& on_sides, const std::array<Vec2, 4>& corners, double s, double t);

/// The crossing of the lines from (f0, 0) to (f2, 1) and from (0, f3) to (1, f1) in the unit square: the blend's (s, t)
/// if opposite sides are divided at different fractions (Soni 1985).
Vec2 crossing_parameters(double f0, double f1, double f2, double f3);

class TransfiniteMap {
 public:
  /// `sides` in counter-clockwise order; `backwards`: the chain of the side runs clockwise. The chains must outlive the
  /// map.
  explicit TransfiniteMap(const std::array<const curve::Chain*, 4>& sides, const std::array<bool, 4>& backwards);

  /// The point at (s, t) in [0,1]^2: s along side 0, t along side 1. On a side exactly the side's own point.
  Vec2 position(double s, double t) const;
  /// The nodes of the block as one quad of order N, ordered as in model/quad_mesh.hpp.
  std::vector<Vec2> sampled(int order) const;

 private:
  Vec2 side(int k, double fraction) const;  ///< fraction counted counter-clockwise
  std::array<const curve::Chain*, 4> sides_;
  std::array<bool, 4> backwards_;
  std::array<Vec2, 4> corners_;
};

}  // namespace quadrille::mesh
