#pragma once
// The outer vertices of a patch of m x m elements at a tip, moved towards a circle about it (refine/tip_rings): rings
// of elements between a square and its copy have angles of 45 degrees and less at its corner, those between arcs do
// not.

#include <set>

#include "model/quad_mesh.hpp"
#include "refine/tip_patch.hpp"

namespace quadrille::refine {

/// Moves the outer vertices of `patch` between the first and the last one along their rays from the tip towards the
/// circle (its radius linear between those of the ends), with the nodes of the elements around them, but for `fixed`
/// ones: by the part of the way with which the least angle of these elements and of the outermost ring is greatest.
/// O(n) for n elements.
void round_outer_vertices(const TipPatch& patch, const std::set<int>& fixed, QuadMesh& mesh);

}  // namespace quadrille::refine
