#pragma once
// Gmsh MSH 4.1 (ASCII): physical groups for boundaries and blocks, orders 1-10, equispaced nodes.

#include "export/format_table.hpp"

namespace quadrille {

/// The format_table's writer.
Exported gmsh_msh41(const QuadMesh& mesh, const Frame& frame);

}  // namespace quadrille
