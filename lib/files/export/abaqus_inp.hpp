#pragma once
// Abaqus .inp in HOHQMesh's flavour (Trixi.jl's P4estMesh and T8codeMesh): straight quads in Abaqus' own words, which
// p4est reads, then curved sides at Chebyshev-Lobatto points and names of sides in comments. Any order.

#include "export/exported.hpp"
#include "export/frame.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// The format_table's writer. Throws ComputeError where an element would be folded once its interior is rebuilt from
/// its sides, and where two edges join the same two vertices, which p4est cannot distinguish.
Exported abaqus_inp(const QuadMesh& mesh, const Frame& frame);

}  // namespace quadrille::exports
