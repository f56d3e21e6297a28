#pragma once
// The names of families in a CGNS file, and their types.

#include <vector>

#include "export/cgns_request.hpp"
#include "export/exported.hpp"
#include "export/groups.hpp"

namespace quadrille::exports {

/// Words for boundaries, then for regions: all different, because families of both stand side by side.
PlainNames family_names(const Groups& groups, Exported& exported);

/// The first `num_boundaries` boundaries, with types by their names, and the regions.
std::vector<CgnsFamily> families(const Groups& groups, const PlainNames& words, int num_boundaries);

}  // namespace quadrille::exports
