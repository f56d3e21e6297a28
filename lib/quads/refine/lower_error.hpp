#pragma once
// The counts of chords that make the error of a smooth solution least, of a mesh whose vertices are placed.
//
// Vertices share lengths among chords by their own energy, which also keeps elements in shape, so that no part of the
// error says what another count of a chord would change. So counts are tried on a mesh that is there
// (refine/count_relaxer): steps of single chords (sizing/error_counts), the estimated best first, of which each is
// taken that lowers the cost
//
//   ln R + sum over blocks of ln (0.7 / least scaled Jacobian, if that is below 0.7),
//
// and 10 ln (0.95 times the first least scaled Jacobian of all, at most 0.7, over that of now) if that is positive, R
// the resolution ratio (mesh/element_sizes); first steps by a quarter of a count, then by one element.

#include "refine/split_mesh.hpp"

namespace quadrille::refine {

/// Places the vertices of `result`, a mesh that is not placed, and sets its prescribed lengths: with such counts, twice
/// from the best ones so far if the first search took four steps or more, as long as the resolution ratio is above 1.5,
/// this lowers it, and the mesh exceeds nothing more than before. Prescribed counts and end lengths, layers, and counts
/// that remedies changed are kept. Vertices of meshes that are compared are nearly in place; those of the last one
/// begin there.
void lower_error(const SplitRequest& request, SplitMesh& result);

}  // namespace quadrille::refine
