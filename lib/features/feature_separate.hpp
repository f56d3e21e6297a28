#pragma once
// Irregular nodes nearer to each other than half the feature size are pushed apart.

#include "features/feature_nodes.hpp"
#include "features/feature_walls.hpp"

namespace quadrille::features {

/// Pushes inner nodes apart that are nearer than size / 2 to another node, both alike, and those that were changed off
/// walls that are not reflex. Says of the pairs for which there is no room that they stay.
void separate(FeatureNodes& state, const Walls& walls);

}  // namespace quadrille::features
