#pragma once
// The quads that a hexahedral mesh sweeps, by their connections alone: what follows from one layer holds for all.

#include "model/hex_mesh.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// The quads below the first layer, without positions: nodes count from 0, blocks have the names of their regions, and
/// the number of a curve is that of the group of faces on it. Throws ComputeError if a side has another name in another
/// layer.
QuadMesh quads_of_layer(const HexMesh& mesh);

}  // namespace quadrille::exports
