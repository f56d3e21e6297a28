#pragma once
// The exact map of a block, the transfinite (Gordon-Hall) blend of its four sides, each by its own arc-length fraction,
// and its shape.

#include <array>
#include <vector>

#include "base/vec2.hpp"
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

// The shape of a block as ONE quad of order 8, the only measure of block quality: the quad interpolates the block's
// exact map at the Gauss-Lobatto-Legendre points.

/// Blocks are measured as quads of this order (TransfiniteMap::sampled).
constexpr int block_order = 8;

struct BlockShape {
  double jacobian_bound = 0;      ///< least Bernstein bound of det J, length^2 (spectral/quad_map.hpp)
  double scaled_jacobian = 0;     ///< least sampled value, -1 where det J <= 0
  Vec2 scaled_jacobian_position;  ///< position of that sample, relative to face.origin

  /// Whether det J is proved positive over the whole block.
  bool is_valid() const { return scaled_jacobian > 0 && jacobian_bound > 0; }
};

BlockShape block_shape(const TransfiniteMap& map);

/// BlockShape::scaled_jacobian of a block sampled at block_order (TransfiniteMap::sampled).
double scaled_jacobian(const std::vector<Vec2>& nodes);
/// BlockShape::is_valid of it; takes longer.
bool is_valid_block(const std::vector<Vec2>& nodes);

}  // namespace quadrille::mesh
