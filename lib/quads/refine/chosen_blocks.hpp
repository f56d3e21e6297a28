#pragma once
// Refinement of chosen blocks: chords that pass none of them get one element, or as many as topology, the boundary's
// tolerance and the proof of validity require.

#include <string>
#include <vector>

#include "model/quad_mesh.hpp"
#include "sizing/grade_chords.hpp"

namespace quadrille::refine {

/// Block numbers, ascending, from "3,inlet,7": numbers or names, which several blocks may have (a name that is a number
/// takes precedence over the number). Throws UsageError for a block that does not exist.
std::vector<int> parse_blocks(const std::string& list, const std::vector<std::string>& block_names);

/// A count of 1 for every chord that passes no block of `chosen` and has none in `prescribed`.
std::vector<sizing::ChordCount> coarse_counts(const sizing::MeasuredLayout& measured, const std::vector<int>& chosen,
                                              const std::vector<sizing::ChordCount>& prescribed);

/// Doubles the counts of those chords of `coarse` that pass a block with an element that is not proved valid; false if
/// there are none.
bool raise_counts(const sizing::MeasuredLayout& measured, const QuadMesh& mesh,
                  std::vector<sizing::ChordCount>& coarse);

/// Counts for all chords that pass a block with an element that is not proved valid: twice the present number of
/// elements, without those in `prescribed`; other counts of `counts` stay. Returns false if there are none.
bool double_counts(const sizing::MeasuredLayout& measured, const QuadMesh& mesh, const sizing::ArcDivisions& divisions,
                   const std::vector<sizing::ChordCount>& prescribed, std::vector<sizing::ChordCount>& counts);

}  // namespace quadrille::refine
