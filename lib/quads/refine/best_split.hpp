#pragma once
// The loop over attempts at a mesh: each is changed by the first remedy that applies to the last one (refine/remedies),
// and the one with the best score (mesh/mesh_score) is kept.

#include "refine/split_mesh.hpp"

namespace quadrille::refine {

/// Attempts, each of which divides all arcs and samples and measures all elements. One or two suffice on real faces; an
/// invalid mesh with layers takes all: four placements of lines with the counts at first, and again after each
/// doubling.
inline constexpr int max_splits = 12;

struct BestSplit {
  SplitMesh split;
  int num_splits = 1;  ///< attempts, at most max_splits
};

/// The loop ends when no remedy applies, when the next attempt would have too many elements, or after max_splits: the
/// best mesh may exceed limits, even be invalid. Of equal ones it is the first. Throws as refine.
BestSplit best_split(const SplitRequest& request);

}  // namespace quadrille::refine
