#pragma once
// Other nodes where those of the field give no layout.

#include "chain/chain_state.hpp"

namespace quadrille::chain {

/// Where separatrix could only divide triangles, its report proposes options of critpoints that change the nodes on a
/// strip of blocks that contains itself (quantize.remedies), or the grid around a body (other_grids). The first that
/// gives a layout replaces nodes, field and graph; if none does, or a stage is stopped, they stay. Options that the
/// user chose are not replaced, nor nodes that a user gave or edited.
void try_remedies(ChainState& chain);

}  // namespace quadrille::chain
