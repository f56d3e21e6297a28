#pragma once
// The middle of a face: the point farthest from the boundary in terms of a smooth distance.

#include <vector>

#include "curve/symmetry.hpp"
#include "model/cad_face.hpp"

namespace quadrille::placement {

/// The point with the largest smooth distance to the boundary (placement/smooth_boundary_distance) among those that are
/// invariant under `group`: if it has a mirror axis, on the axis. Not for groups with rotations, which have a single
/// invariant point.
Vec2 most_interior_point(const CadFace& face, const std::vector<curve::Isometry>& group);

}  // namespace quadrille::placement
