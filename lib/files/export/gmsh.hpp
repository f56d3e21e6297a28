#pragma once
// Gmsh MSH (ASCII), versions 4.1 and 2.2: physical groups for boundaries and blocks, orders 1-10, equispaced nodes.

#include "export/exported.hpp"
#include "export/frame.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// The format_table's writers.
Exported gmsh_msh41(const QuadMesh& mesh, const Frame& frame);
Exported gmsh_msh22(const QuadMesh& mesh, const Frame& frame);

}  // namespace quadrille::exports
