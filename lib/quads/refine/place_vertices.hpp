#pragma once
// Moves the vertices of a mesh whose counts are settled: the one place for what improves their positions.
//
//   1. With layers, lines along the normals of walls are straightened (growth/straighten_lines) in the blocks that gain
//      by it.
//   2. Lines inside blocks are corrected from the intervals that the mesh has (growth/line_intervals), a few times.
//   3. With the option `relax`, vertices are relaxed (refine/relax).
//
// 1 and 2 are kept if they improve the score of the mesh (mesh/mesh_score); 3 never lowers its least scaled Jacobian.

#include "refine/split_mesh.hpp"

namespace quadrille::refine {

/// The elements and the score of the mesh are measured again.
void place_vertices(const SplitRequest& request, SplitMesh& result);

}  // namespace quadrille::refine
