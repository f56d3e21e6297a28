#pragma once
// HOHQMesh ISM-V2 (Trixi.jl's UnstructuredMesh2D, SELF): corners, edges with their elements, curved sides at
// Chebyshev-Lobatto points, names of sides. ISM-MM has the materials of elements, and no edges. Any order.

#include "export/exported.hpp"
#include "export/frame.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// The format_table's writers. They throw ComputeError where an element would be folded once its interior is rebuilt
/// from its sides.
Exported hohqmesh_ism(const QuadMesh& mesh, const Frame& frame);
Exported hohqmesh_ism_mm(const QuadMesh& mesh, const Frame& frame);

}  // namespace quadrille::exports
