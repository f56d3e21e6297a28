#pragma once
// HOHQMesh ISM-V2 (Trixi.jl's UnstructuredMesh2D, SELF): corners, edges with their elements, curved sides at
// Chebyshev-Lobatto points, names of sides. Any order.

#include "export/exported.hpp"
#include "export/frame.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// The format_table's writer. Throws ComputeError where an element would be folded once its interior is rebuilt from
/// its sides.
Exported hohqmesh_ism(const QuadMesh& mesh, const Frame& frame);

}  // namespace quadrille::exports
