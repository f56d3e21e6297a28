#pragma once
// Makes the final mesh from the blocks of a layout.
//
//   1. Measure the arcs of the layout (sizing/measured_layout) and align lines across chords (refine/align_chords), in
//      one half of a symmetric whole with those of the whole (sizing/halved_blocks).
//   2. Share out prescribed numbers of elements along boundaries among the chords (prescribe/boundary_counts).
//   3. Attempt a mesh (refine/split_mesh):
//        a. plan one count and one grading for each chord from the size field (sizing/grade_chords), the prescribed
//           lengths at ends (prescribe/end_grading) and the limits on lengths (refine/length_limits);
//        b. divide the arcs so that the boundary meets its tolerance (refine/divide_arcs);
//        c. cut layers along walls (layers/wall_layers) and limit the growth from wall to wall (growth/smooth_walls);
//        d. make both sides of periodic pairs equal (refine/divide_arcs);
//        e. sample elements from the exact maps of the blocks (refine/split_isoparametric), with layers on lines that
//           grow smoothly (growth/line_intervals) where these do not make blocks more skew;
//        f. bound det J of each element from below (refine/validity), measure lengths and the distance from the CAD
//           curves, and score the mesh (mesh/mesh_score).
//   4. As long as a remedy applies, attempt it again with its settings, at most 12 times in all; the best mesh is kept
//      (refine/best_split).
//   5. Place its vertices better: straight lines along walls, corrected lines, relaxation (refine/best_split); make
//      edges inside straight where elements allow it (refine/inner_edges).
//   6. By the size rule `error`, move elements from chord to chord, as long as 3 to 5 then make a mesh of less error,
//      with vertices nearly in place until counts are settled (refine/lower_error).
//   7. On a curved face, lift the nodes from the chart to the surface, symmetric where a reflection exchanges outline
//      and hole (refine/swapped_ends); where elements are too far from it, or not proved in space, prescribe shorter
//      edges and begin again at 3 (refine/lifted_split); at tips of the surface, add rings of elements
//      (refine/tip_rings).
//   8. Split every element into equal parts of its own map (mesh/nested_quads), and lift those.
//   9. Report, and refuse a mesh that is not valid or misses a prescribed quality (refine/validity).

#include "base/report.hpp"
#include "model/block_layout.hpp"
#include "model/quad_mesh.hpp"
#include "refine/refine_options.hpp"

namespace quadrille::refine {

/// Throws ComputeError with the position of the worst element if one cannot be proved valid (unless allow_invalid) or
/// misses min_scaled_jacobian or max_edge_ratio, and if the mesh would have more than max_elements or
/// 1e8 nodes.
QuadMesh refine(const BlockLayout& layout, const RefineOptions& options, Report& report);

}  // namespace quadrille::refine
