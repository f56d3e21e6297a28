#pragma once
// A Nek5000 field file (0.f00000) that contains only the geometry, in double precision, at Gauss-Lobatto-Legendre
// points: Nek5000 uses them as the positions of its own points.

#include <string>

#include "export/frame.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// The file's bytes, little-endian. Elements in the order of the mesh.
std::string nek_geometry_field(const QuadMesh& mesh, const Frame& frame);

}  // namespace quadrille::exports
