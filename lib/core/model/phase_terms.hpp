#pragma once
// The explicit part of a phase (lib/method.md §8.3):
//   sum_k d_k arg(z - a_k) + sum_j D_j arg(z - h_j) + sum_c beta_c theta_c,   theta_c = Arg((z - c) / (z - p_c)),
// and, so that the remainder is smooth, sum d_k arg(z - a_k*) over mirror images a_k* outside the domain
// (field/turn_centres). An image inside hole j is subtracted from D_j, so that the winding round the hole stays the
// same.

#include <vector>

#include "base/vec2.hpp"

namespace quadrille {

/// turns * arg(z - position).
struct PhaseTurn {
  Vec2 position;
  int turns = 0;
};

/// beta * theta_c.
struct CornerAngle {
  Vec2 apex;        ///< c, on the boundary
  Vec2 pole;        ///< p_c, outside the domain
  double beta = 0;  ///< 4 - 2 pi V_c / omega_c
};

struct PhaseTerms {
  std::vector<PhaseTurn> nodes;   ///< a_k, d_k = 4 - V_k, in the order of the prescribed nodes
  std::vector<PhaseTurn> holes;   ///< h_j inside hole j, D_j less the images there; one per hole, loops 1, 2, ...
  std::vector<PhaseTurn> images;  ///< a_k*, d_k
  std::vector<CornerAngle> corner_angles;
};

}  // namespace quadrille
