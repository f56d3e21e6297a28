#pragma once
// The irregular nodes and corner valences prescribed for a cross field: the input of the phase form (lib/method.md §8).
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

}  // namespace quadrille
