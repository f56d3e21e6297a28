#pragma once
// Orders for the phase form on a mesh for which the orders of the harmonic field are known.

#include <vector>

#include "model/tri_mesh.hpp"

namespace quadrille::galerkin {

/// An order for each element at which s (lib/method.md §8.3) is resolved as v is with `field_orders`.
///
/// s is smoother than v, which turns four times as far as the cross and has no explicit terms: on the 30 shapes of the
/// tests and on plates with 1,000 holes it needs at most half of the order of v and 5 more. Along straight boundaries,
/// where the data of v are constant but not those of s, and in corner fans, where both have the same singularity, it
/// may need as much as v. No order exceeds that of v.
std::vector<int> phase_orders(const TriMesh& mesh, const std::vector<int>& field_orders);

}  // namespace quadrille::galerkin
