#pragma once
// A table of names beside the mesh, for formats whose groups have numbers only or restricted names: x.re2.names.json =
// {"boundaries": [{"id": 1, "name": "wall"}, ...], "regions": [{"id": 1, "name": "block_0"}, ...]}, with "interfaces"
// between them where the file has interfaces.

#include <string>
#include <vector>

#include "export/exported.hpp"
#include "export/groups.hpp"

namespace quadrille::exports {

struct NamedGroup {
  int id = 0;        ///< the group's number in the main file
  std::string name;  ///< its name in the CAD model or from the user, UTF-8
  std::string tag;   ///< its name in the main file; empty if it has no names or uses this one unchanged
};

/// Behind the name of the main file, so that those of two formats differ.
inline const SideName names_table_name{".names.json", true};

/// The table as a side file.
SideFile names_table(const std::vector<NamedGroup>& boundaries, const std::vector<NamedGroup>& regions,
                     const std::vector<NamedGroup>& interfaces = {});

/// The same, numbered in the order of the groups: boundaries count from `first_boundary`, then interfaces, regions from
/// `first_region`.
SideFile names_table(const Groups& groups, int first_boundary = 1, int first_region = 1);

}  // namespace quadrille::exports
