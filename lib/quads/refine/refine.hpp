#pragma once
// Makes the final mesh from the blocks of a layout.
//
//   1. Measure the arcs of the layout (sizing/measured_layout) and align lines across chords (refine/align_chords).
//   2. Plan one count and one grading for each chord from the size field (sizing/grade_chords).
//   3. Divide the arcs so that the boundary meets its tolerance (refine/divide_arcs), and cut wall layers
//      (layers/wall_layers).
//   4. Sample elements from the exact maps of the blocks (refine/split_isoparametric) and bound det J from below
//      (refine/validity). The counts of chords outside chosen blocks are raised until all elements are proved valid.
//   5. Move vertices so that elements have better shapes (refine/relax).
//   6. Split every element into equal parts of its own map (mesh/nested_quads).

#include "base/report.hpp"
#include "model/block_layout.hpp"
#include "model/quad_mesh.hpp"
#include "refine/refine_options.hpp"

namespace quadrille::refine {

/// If aligned lines result in an invalid element and equal arc-length fractions do not, the mesh has equal fractions.
/// Throws ComputeError with the position of the worst element if one cannot be proved valid (unless allow_invalid) or
/// misses min_scaled_jacobian or max_edge_ratio, and if the mesh would have more than max_elements or
/// 1e8 nodes.
QuadMesh refine(const BlockLayout& layout, const RefineOptions& options, Report& report);

}  // namespace quadrille::refine
