#pragma once
// Nek5000 .re2: corners, quadratic sides, numbers of boundaries; beside it the geometry of full order as a field file
// NAME0.f00000 to start from (.par: startFrom = "NAME0.f00000 X") and the table of names. Any order.

#include "export/exported.hpp"
#include "export/frame.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// Of the field file.
inline const SideName nek_field_name{"0.f00000"};

/// The format_table's writer. Throws ComputeError where an element would be folded once its interior is rebuilt from
/// its sides, and where two edges join the same two vertices, which Nek5000 cannot distinguish.
Exported nek_re2(const QuadMesh& mesh, const Frame& frame);

}  // namespace quadrille::exports
