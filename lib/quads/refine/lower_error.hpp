#pragma once
// The counts of chords that make the error of a smooth solution least (sizing/error_counts), of a mesh whose vertices
// are placed: its parts of the error are those that the counts change first.

#include "refine/split_mesh.hpp"

namespace quadrille::refine {

/// Splits the blocks again with such counts, at most six times, as long as the resolution ratio is above 1.5, this
/// lowers it, and the mesh exceeds nothing more than before. Prescribed counts and end lengths, layers, and counts that
/// remedies changed are kept. `result`: placed, with prescribed lengths; so it is returned.
void lower_error(const SplitRequest& request, SplitMesh& result);

}  // namespace quadrille::refine
