#pragma once
// A quad mesh as a plate of hexahedra one cell thick, as OpenFOAM's cases of two dimensions are.

#include <vector>

#include "export/groups.hpp"
#include "export/patches.hpp"
#include "mesh/straight_cells.hpp"
#include "model/hex_mesh.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

struct PlateMesh {
  HexMesh mesh;  ///< order 1, hexahedron k of quad k; a group for each boundary, interface, and the ends
  std::vector<PatchType> types;  ///< those chosen, and `empty` of the ends
};

/// Straight sides between the corners of the quads, z from 0 to a tenth of the face's diameter. Groups of cyclic
/// patches (`cyclic`: by boundary) are images of each other, face by face.
PlateMesh plate_mesh(const QuadMesh& mesh, const Frame& frame, const Groups& groups,
                     const std::vector<CyclicPatch>& cyclic, const std::vector<PatchType>& types);

/// The cells of the plate, relative to face.origin, cyclic patches coupled.
mesh::StraightCells straight_cells(const QuadMesh& mesh, const std::vector<PatchType>& types);

}  // namespace quadrille::exports
