#pragma once
// Nektar++ XML: vertices, edges, quads, curved edges and, where the sides do not determine the element, curved faces;
// composites with names for boundaries and regions; a default expansion. Any order; the nodes are those of the quad
// mesh (GaussLobattoLegendre).

#include "export/exported.hpp"
#include "export/frame.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// The format_table's writer. Lossless but for control characters in names, which XML cannot represent. SPACE="3" if
/// the frame is not the plane z = 0.
Exported nektar_xml(const QuadMesh& mesh, const Frame& frame);

}  // namespace quadrille::exports
