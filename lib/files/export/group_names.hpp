#pragma once
// Names of groups for formats that have numbers only, allow single words only, or have none for regions; and a table of
// the names beside the mesh: x.re2.names.json = {"boundaries": [{"id": 1, "name": "wall"}, ...], "regions": [{"id": 1,
// "name": "block_0"}, ...]}, with "interfaces" between them where the file has interfaces.

#include <string>
#include <vector>

#include "export/exported.hpp"
#include "export/groups.hpp"

namespace quadrille::exports {

using NameList = std::vector<std::string>;  ///< names of groups in a file, group by group

/// Each name by ASCII letters, digits and _ . - alone, the first one a letter or _ ; any other character becomes _ .
/// Names that would coincide, also with one of `taken`, are numbered (_2, _3, ...). Names that are such words already
/// are not changed.
NameList plain_names(const NameList& names, const NameList& taken = {});

/// "1 name is written in plain letters: \"outer wall\" as outer_wall" for the first few; empty if none is.
std::string renamed_loss(const NameList& names, const NameList& plain);

/// The table as a side file: .names.json behind the name of the main file, so that those of two formats differ. Groups
/// count from 1, in the order of the mesh, interfaces after the boundaries. `boundaries` and `regions` are what the
/// main file calls them: a word that is not the name is listed as its "tag"; regions are omitted if `regions` is empty.
SideFile names_table(const Groups& groups, const NameList& boundaries, const NameList& regions,
                     bool with_interfaces = false);

/// Single words for the names of all groups, and a report of the loss with the table of the names, if there is one.
/// Without regions, those have no words and no loss.
struct PlainNames {
  NameList boundaries, regions;
};
PlainNames add_plain_names(const Groups& groups, bool with_regions, const NameList& taken, Exported& exported);

/// "2 interfaces are not stored: \"fluid-solid\", \"wake\"" for formats that name the boundary alone; empty if there is
/// none.
std::string interface_loss(const Groups& groups);

/// "3 region names are not stored". Empty if nothing is lost: one name for all, or only the default names
/// block_<number>.
std::string region_loss(const Groups& groups);

}  // namespace quadrille::exports
