#pragma once
// The mesh of a curved face in space, for the pane beside its chart (view/space.js).

#include "model/quad_mesh.hpp"
#include "page/page_data.hpp"

namespace quadrille::page {

/// Outlines of the elements in space, relative to the middle of their box, the extent of all, and the axes of the
/// isometric view (draw/draw_in_space). The mesh must have nodes in space.
JsonObject space_data(const QuadMesh& mesh);

}  // namespace quadrille::page
