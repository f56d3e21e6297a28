#pragma once
// Pairs of OpenFOAM's cyclic patches, and of Nektar++'s periodic composites, from the periodic sides of a mesh.

#include <string>
#include <string_view>
#include <vector>

#include "export/groups.hpp"
#include "export/patch_types.hpp"
#include "export/plate_blocks.hpp"

namespace quadrille::exports {

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
