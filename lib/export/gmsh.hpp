#pragma once
// Gmsh MSH 4.1 (ASCII): physical groups for boundaries and blocks, orders 1-10, equispaced nodes.

#include <string>

#include "model/quad_mesh.hpp"

namespace quadrille {

/// The file's text. Throws ComputeError for an order that the format cannot hold.
std::string gmsh_msh41(const QuadMesh& mesh);

}  // namespace quadrille
