#pragma once
// The separatrix graph and the blocks for one choice of nodes.

#include "chain/chain_state.hpp"

namespace quadrille::chain {

/// The graph of the nodes of `files`; first a field of their own, if they need one. Returns false as run_stage does.
bool make_graph(ChainState& chain, NodeFiles& files);

/// The blocks of `files.graph`. Returns false as run_stage does.
bool make_blocks(ChainState& chain, NodeFiles& files);

/// The options of separatrix, with what makes midpoint division possible.
stage::SeparatrixOptions layout_options(const ChainState& chain);

}  // namespace quadrille::chain
