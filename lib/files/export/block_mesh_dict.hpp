#pragma once
// OpenFOAM's blockMeshDict: one hexahedral block for each block of the layout, one cell thick, its sides as splines
// with one graded section for each cell, boundaries as patches, regions as cell zones. The mesh may have any order;
// cells have straight sides.

#include "export/exported.hpp"
#include "export/frame.hpp"
#include "export/patch_types.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// The writer in format_table. `types`: of patches, where they shall not follow from the names. Throws ComputeError if
/// a cell with straight sides is not convex.
Exported block_mesh_dict(const QuadMesh& mesh, const Frame& frame, const std::vector<PatchType>& types = {});

}  // namespace quadrille::exports
