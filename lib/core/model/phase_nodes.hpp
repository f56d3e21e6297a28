#pragma once
// The irregular nodes and corner valences prescribed for a cross field, the input of the phase form (lib/method.md §8),
// and the explicit part of the phase that they lead to.
// Positions are relative to face.origin. The audit (field/phase_boundary.hpp) requires
//   sum over nodes (4 - V) + sum over corners and boundary nodes (2 - V) = 4 chi.

#include <vector>

#include "base/vec2.hpp"

namespace quadrille {

struct PhaseNode {
  Vec2 position;    ///< a_k, inside the domain
  int valence = 3;  ///< V_k = 4 - d_k
  bool operator==(const PhaseNode&) const = default;
};

struct CornerValence {
  int joint = 0;    ///< index into face.joints; it may be a smooth one
  int valence = 2;  ///< V_c; joints that are not listed have 2
  bool operator==(const CornerValence&) const = default;
};

/// A node on a smooth boundary point: a corner with omega = pi (lib/method.md §8.8).
struct BoundaryNode {
  int curve = 0;
  double t = 0;     ///< parameter, inside the curve
  int valence = 3;  ///< 3 for a mesh; 1 is valid for a field only
  bool operator==(const BoundaryNode&) const = default;
};

struct PhaseNodes {
  std::vector<PhaseNode> nodes;
  std::vector<CornerValence> corners;
  std::vector<BoundaryNode> boundary_nodes;
  bool operator==(const PhaseNodes&) const = default;
};

// The explicit part of a phase (lib/method.md §8.3):
//   sum_k d_k arg(z - a_k) + sum_j D_j arg(z - h_j) + sum_c beta_c theta_c,   theta_c = Arg((z - c) / (z - p_c)),
// and, so that the remainder is smooth, sum d_k arg(z - a_k*) over mirror images a_k* outside the domain
// (field/explicit_terms). An image inside hole j is subtracted from D_j, so that the winding round the hole stays the
// same.

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
