#pragma once
// Hexahedra cut into smaller ones of order 1, for formats that have no higher order.

#include <string>

#include "model/hex_mesh.hpp"

namespace quadrille::exports {

/// Hexahedra with straight edges between the nodes of a mesh of order N: N^3 for each, of a swept quad N^2 quads, xi1
/// fastest, of a layer N layers. Nodes, groups and regions are those of the mesh. Bounds of det J are those of the
/// small hexahedra, which have no samples; is_valid says whether all of them are proved. Linear cost.
HexMesh split_at_nodes(const HexMesh& mesh);

/// Throws ComputeError with the position if det J of an element is not proved positive. `reader`: "SU2's cells", for
/// the message.
void require_valid_pieces(const HexMesh& pieces, const std::string& reader);

/// "elements have straight edges, which moves the boundary by up to 0.02 (0.001 of the diameter)": the largest
/// component of the distance of the boundary of `mesh` from that of split_at_nodes of it that is normal to the latter,
/// on 5 x 5 points of each small face, ends included. Empty below 1e-12 of the diameter.
std::string split_loss(const HexMesh& mesh);

}  // namespace quadrille::exports
