#pragma once
// What is changed from one attempt at a mesh to the next, by what the last one exceeds.
//
//   elements that are not proved valid:  1. no limit on the growth, 2. lines at equal fractions, 3. more elements on
//                                        chords outside the chosen blocks, 4. on all chords; 3 and 4 restore 1 and 2
//   distance from the CAD curves:        5. a stricter tolerance of divisions, whose own samples are fewer
//   ratio of the sides of an element:    6. shorter elements there (refine/length_limits)

#include <span>

#include "refine/split_mesh.hpp"

namespace quadrille::refine {

/// Changes the settings of the next attempt; returns false if it changes nothing: because `last` does not need it, or
/// because nothing is left to change.
using Remedy = bool (*)(const SplitRequest& request, const SplitMesh& last, SplitSettings& settings);

/// In the order in which they are tried.
std::span<const Remedy> remedies();

}  // namespace quadrille::refine
