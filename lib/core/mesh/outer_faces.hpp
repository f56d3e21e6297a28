#pragma once
// What is seen of a hexahedral mesh: its outer faces, as a quad mesh in space.

#include "model/hex_mesh.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::mesh {

/// The faces of all groups but interfaces, each with its nodes in order, the block and the figures of its element; an
/// edge between two groups is a boundary edge, `curve` the number of its own group. `nodes` are all (0, 0): the quads
/// have positions in space alone.
QuadMesh outer_faces(const HexMesh& mesh);

}  // namespace quadrille::mesh
