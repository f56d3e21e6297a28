#pragma once
// Names for formats that allow single words only, or none for regions.

#include <string>
#include <vector>

#include "export/exported.hpp"
#include "export/groups.hpp"

namespace quadrille::exports {

/// Each name by ASCII letters, digits and _ . - alone, the first one a letter or _ ; any other character becomes _ .
/// Names that would coincide, also with one of `taken`, are numbered (_2, _3, ...). Names that are such words already
/// are not changed.
std::vector<std::string> plain_names(const std::vector<std::string>& names, const std::vector<std::string>& taken = {});

/// "1 name is written in plain letters: \"outer wall\" as outer_wall" for the first few; empty if none is.
std::string renamed_loss(const std::vector<std::string>& names, const std::vector<std::string>& plain);

/// The table beside the mesh: number in the order of the mesh from 1, name, and the word that replaces it, if any.
/// Regions are omitted if `zones` is empty.
SideFile plain_names_table(const Groups& groups, const std::vector<std::string>& boundaries,
                           const std::vector<std::string>& zones = {});

/// "2 interfaces are not stored: \"fluid-solid\", \"wake\"" for formats that name the boundary alone; empty if there is
/// none.
std::string interface_loss(const Groups& groups);

/// "3 region names are not stored". Empty if nothing is lost: one name for all, or only the default names
/// block_<number>.
std::string region_loss(const Groups& groups);

}  // namespace quadrille::exports
