#pragma once
// Names of blocks: blocks of equal name are one region to a solver.

#include <vector>

#include "model/block_layout.hpp"
#include "model/name_rules.hpp"

namespace quadrille::block {

/// Sets the name of every block to that of its region or, where there is one region, to the name of the face, if it has
/// one (else "block_N" is kept), then the names of `rules`. Throws FormatError, with the position of the rule, for a
/// number without block, a point in no block or on the side of one (within 1e-6 diameters), and for two rules that name
/// the same block.
void name_blocks(BlockLayout& layout, const std::vector<NameRule>& rules);

}  // namespace quadrille::block
