#pragma once
// OpenFOAM's types of boundary patches, which follow from the names of the boundaries or from --patch-type
// (formats/export/openfoam.md, "Types of patches"), and pairs of its cyclic patches, which are also Nektar++'s periodic
// composites, from the periodic sides of a mesh.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "export/groups.hpp"
#include "export/plate_blocks.hpp"

namespace quadrille::exports {

/// NAME=TYPE of --patch-type: all boundaries whose name fits the pattern (base/name_text) get the type.
struct PatchType {
  std::string pattern, type;
};

/// Throws UsageError for a text without "=", or a type that is not one of patch, wall, symmetryPlane, symmetry, empty
/// and wedge (others need entries that only the user knows).
std::vector<PatchType> patch_type_options(const std::vector<std::string>& options);

/// The type of each boundary: the last fitting one of `chosen`; else by the beginning of the name, in upper or lower
/// case: wall, symmetry (symmetryPlane if all its edges lie on one line, within 1e-6 diameters), empty; else patch.
/// Throws as require_boundaries.
std::vector<std::string> patch_types(const QuadMesh& mesh, const Groups& groups, const std::vector<PatchType>& chosen);

/// Of hexahedra a boundary on one plane is a symmetryPlane.
std::vector<std::string> patch_types(const HexMesh& mesh, const Groups& groups, const std::vector<PatchType>& chosen);

/// The same of any mesh; `is_flat`: whether a boundary lies on one line or plane.
std::vector<std::string> patch_types(const Groups& groups, const std::vector<PatchType>& chosen,
                                     const std::function<bool(int boundary)>& is_flat);

/// Metres of a unit by its name in files; 1 where that is unknown.
double metres_or_one(const std::string& unit);

/// Whether one of `chosen` fits the name.
bool is_type_chosen(const std::string& name, const std::vector<PatchType>& chosen);

/// Largest distance of the boundary's points from the straight sides of the cells, and a sentence about it.
double boundary_distance(const QuadMesh& mesh);
std::string straight_sides_loss(double moved, double diameter);

/// Throws UsageError, with the nearest name, for an entry of `chosen` that fits none of the names of boundaries.
void require_boundaries(const std::vector<std::string>& names, const std::vector<PatchType>& chosen);

struct CyclicPatch {
  int neighbour = -1;     ///< boundary; -1: the patch is not cyclic
  int pair = -1;          ///< of CadFace::periodic_pairs: one of those of the patch, all have the same motion
  bool is_first = false;  ///< the motion maps this patch onto its neighbour, else the neighbour onto this patch
};

/// By boundary. A patch is cyclic if one motion maps all its curves onto all curves of another patch, and if none of
/// `chosen` fits the name of either.
std::vector<CyclicPatch> cyclic_patches(const QuadMesh& mesh, const Groups& groups,
                                        const std::vector<PatchType>& chosen);

/// Gives the sides of each second cyclic patch the order of their partners, and turns blocks so that also blockMesh's
/// cells along them have the same order. Patches of a block that cannot be turned so are not cyclic afterwards: it has
/// opposite sides on two first patches, or on two second ones.
void order_cyclic_blocks(const QuadMesh& mesh, const Groups& groups, std::vector<CyclicPatch>& cyclic,
                         PlateBlocks& plates);

/// The entries of a cyclic patch after its neighbour: the kind of motion and its numbers, lengths times `scale`, each
/// line ending in a line feed and indented as in the dictionary.
std::string cyclic_transform(const CadFace& face, const CyclicPatch& patch, double scale);

/// A sentence about the periodic sides that are no cyclic patches, with the condition that they do not satisfy; empty
/// if there are none.
std::string cyclic_loss(const CadFace& face, const Groups& groups, const std::vector<CyclicPatch>& cyclic,
                        std::string_view condition);

}  // namespace quadrille::exports
