#pragma once
// A mesh in space, for the pane that turns it and cuts it (view/space.js): faces, each with its outline and the one or
// two elements that it bounds.

#include "model/hex_mesh.hpp"
#include "model/quad_mesh.hpp"
#include "page/page_data.hpp"

namespace quadrille::page {

/// Points relative to the middle of their box, outlines as indices of points, the extent of all, and the axes of the
/// first view (draw/draw_in_space). The quads must have nodes in space.
JsonObject space_data(const QuadMesh& mesh);
/// All faces, also those between elements, which a cut shows.
JsonObject space_data(const HexMesh& mesh);

}  // namespace quadrille::page
