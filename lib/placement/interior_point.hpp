#pragma once
// The middle of a face: the point that is farthest from the boundary in a smooth sense.

#include <vector>

#include "curve/symmetry.hpp"
#include "model/cad_face.hpp"

namespace quadrille::placement {

/// The point with the largest smooth distance to the boundary (placement/smooth_boundary_distance) among those that are
/// invariant under `group`: on the mirror axis where there is one. Not for groups with rotations: they have one fixed
/// point.
Vec2 most_interior_point(const CadFace& face, const std::vector<curve::Isometry>& group);

}  // namespace quadrille::placement
