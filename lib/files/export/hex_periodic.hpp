#pragma once
// Periodic faces of a hexahedral mesh, node by node.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "export/hex_numbering.hpp"
#include "export/periodic_edges.hpp"
#include "model/hex_mesh.hpp"

namespace quadrille::exports {

/// Two faces of which the motion of `group` maps the first onto the second.
struct PeriodicFaces {
  int group = 0;  ///< of HexMesh::face_groups: that of the first face; the other is its periodic_with
  GroupFace first, second;
  std::vector<std::array<int, 2>> nodes;  ///< mesh nodes: of the first face in its order, each with its image
};

/// Groups that name each other are one pair: that of the lower number with its motion. Throws ComputeError, with the
/// place, for a face that has no image within 1e-9 diameters.
std::vector<PeriodicFaces> periodic_faces(const HexMesh& mesh);

/// Whether the motion of a group is a translation.
bool is_translation(const SpaceMotion& motion);

/// A sentence that the format does not store that faces are periodic, with their names, and why, if that is not empty.
/// Empty without periodic faces.
std::string periodic_loss(const HexMesh& mesh, std::string_view why = {});

/// As for quads; edges and faces must still be known by their vertices afterwards.
PeriodicVertices periodic_vertices(const HexMesh& mesh, const HexNumbering& numbering, Motions motions,
                                   const char* reader);

}  // namespace quadrille::exports
