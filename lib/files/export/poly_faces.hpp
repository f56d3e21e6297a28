#pragma once
// The faces of OpenFOAM's polyMesh of hexahedra: inner ones, then those of each patch, with owners and neighbours.

#include <array>
#include <string>
#include <vector>

#include "export/groups.hpp"
#include "export/hex_numbering.hpp"
#include "export/patches.hpp"
#include "mesh/straight_cells.hpp"
#include "model/hex_mesh.hpp"

namespace quadrille::exports {

struct PolyFace {
  std::array<int, 4> vertices{};  ///< the outside of the owner on the reader's side
  int owner = 0, neighbour = -1;
};

struct PolyPatch {
  std::string type = "patch", entries;  ///< the entries of a cyclic patch behind its type
  std::vector<PolyFace> faces;
  int neighbour = -1;       ///< of a cyclic patch the other one, whose faces are in the order of their partners
  bool is_first = false;    ///< of the two
  SpaceMotion motion = {};  ///< of the first patch onto the second, in the unit of the mesh
};

struct PolyFaces {
  Groups groups;
  HexNumbering numbering;
  std::vector<PolyFace> inner;     ///< by owner, then by neighbour, as OpenFOAM's matrices are stored
  std::vector<PolyPatch> patches;  ///< by boundary
  bool are_periodic_lost = false;  ///< some periodic faces are no cyclic patches
};

/// A pair of groups is a pair of cyclic patches if each is the whole patch of its name, moved by one translation or
/// rotation, and `types` chooses the type of neither. Throws UsageError as patch_types, ComputeError for a face of the
/// boundary that is in no group or in two.
PolyFaces poly_faces(const HexMesh& mesh, const std::vector<PatchType>& types);

/// "(x y z)", no coordinate -0.
std::string vector_text(Vec3 x);

/// The cells with straight edges between the corners of the mesh, its cyclic patches coupled, its patches of the type
/// symmetryPlane as planes.
mesh::StraightCells straight_cells(const HexMesh& mesh, const PolyFaces& faces);

}  // namespace quadrille::exports
