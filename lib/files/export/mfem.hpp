#pragma once
// MFEM mesh v1.0 and v1.3 (named attribute sets): any order, the nodes of the quad mesh (H1, Gauss-Lobatto), regions
// and boundaries as attributes counted from 1 each.

#include "export/exported.hpp"
#include "export/frame.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// The format_table's writers. Positions are lossless; v1.0 has no names, they are written to a table beside it. Three
/// coordinates if the frame is not the plane z = 0. Throws ComputeError if two edges join the same two vertices (MFEM
/// identifies edges by their ends).
Exported mfem_mesh10(const QuadMesh& mesh, const Frame& frame);
Exported mfem_mesh13(const QuadMesh& mesh, const Frame& frame);

}  // namespace quadrille::exports
