#pragma once
// Pairs of irregular nodes of opposite index that are nearer to each other than a length cancel.

#include "features/feature_nodes.hpp"
#include "features/feature_walls.hpp"

namespace quadrille::features {

/// Nearest first. Pairs of equal distance (within `tie`) are decided together: what they link becomes nothing where its
/// indices add up to 0, one inner node in their middle where they add up to +-1 and all are inside, and stays as it is
/// otherwise. Pairs that do not see each other stay. Boundary nodes take part, but do not cancel among themselves.
void cancel_pairs(FeatureNodes& state, const Walls& walls, double below);

}  // namespace quadrille::features
