#pragma once
// OpenFOAM's types of boundary patches, which follow from the names of the boundaries or from --patch-type
// (formats/export/openfoam.md, "Types of patches").

#include <string>
#include <vector>

#include "export/groups.hpp"

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

/// Throws UsageError, with the nearest name, for an entry of `chosen` that fits none of the names of boundaries.
void require_boundaries(const std::vector<std::string>& names, const std::vector<PatchType>& chosen);

}  // namespace quadrille::exports
