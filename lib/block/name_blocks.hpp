#pragma once
// Names of blocks: blocks that share a name are one region to a solver.

#include <vector>

#include "model/block_layout.hpp"
#include "model/name_rules.hpp"

namespace quadrille::block {

/// Gives every block the face's name, where the face has one (else they stay "block_N"), then the names of `rules`.
/// Throws FormatError, with the rule's place, for a number without block, a place in no block or on the side of one
/// (within 1e-6 diameters), and for two rules that name the same block.
void name_blocks(BlockLayout& layout, const std::vector<NameRule>& rules);

}  // namespace quadrille::block
