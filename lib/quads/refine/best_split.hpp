#pragma once
// The loop over attempts at a mesh: each is changed by the first remedy that applies to the last one, and the one with
// the best score (mesh/mesh_score) is kept. Remedies, by what the last attempt exceeds:
//
//   elements that are not proved valid:  1. no limit on the growth, 2. lines at equal fractions, 3. more elements on
//                                        chords outside the chosen blocks, 4. on all chords; 3 and 4 restore 1 and 2
//   distance from the CAD curves:        5. a stricter tolerance of divisions, whose own samples are fewer
//   ratio of the sides of an element:    6. shorter elements there (refine/length_limits)

#include <optional>
#include <span>

#include "refine/size_relaxer.hpp"
#include "refine/split_mesh.hpp"

namespace quadrille::refine {

/// Changes the settings of the next attempt; returns false if it changes nothing: because `last` does not need it, or
/// because nothing is left to change.
using Remedy = bool (*)(const SplitRequest& request, const SplitMesh& last, SplitSettings& settings);

/// In the order in which they are tried.
std::span<const Remedy> remedies();

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

/// How vertices of a mesh with these counts are relaxed to the prescribed sizes.
SizeRelaxation size_relaxation(const SplitRequest& request, const SplitMesh& split);

/// Moves the vertices of a mesh whose counts are settled: the one place for what improves their positions.
///
///   1. With layers, lines along the normals of walls are straightened (growth/straighten_lines) in the blocks that it
///      improves.
///   2. Lines inside blocks are corrected from the intervals that the mesh has (growth/line_intervals), a few times.
///   3. By the option `relax`, vertices move to the prescribed sizes or better shapes (refine/relax_sizes).
///   4. Edges inside become straight (refine/inner_edges) but on chords with layers, which keep their shape.
///
/// 1 and 2 are kept if they improve the score of the mesh, 3 if it does not make it worse; shapes never lower its least
/// scaled Jacobian, straight edges not below 0.6. The elements and the score of the mesh are measured again.
/// `least_progress`: of relaxation (SizeRelaxation), which begins at result.vertices, if there are any.
void place_vertices(const SplitRequest& request, SplitMesh& result, double least_progress = fine_progress);

/// Relaxes vertices further that were placed with a greater least progress.
void place_further(const SplitRequest& request, SplitMesh& result, double least_progress);

/// The same, not placed, with shorter elements in place of those that are still too long in a placed mesh, however
/// short the boundary is (refine/length_limits). None if there are none, or if that takes more than twice as many
/// elements.
std::optional<SplitMesh> with_shorter_elements(const SplitRequest& request, const SplitMesh& placed);

}  // namespace quadrille::refine
