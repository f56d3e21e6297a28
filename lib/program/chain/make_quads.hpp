#pragma once
// From triangles to quads, by the field or without it.

#include "chain/chain.hpp"

namespace quadrille::chain {

/// Runs the stages between cad2tri and quadexport. With the layout `auto`, the quads are made from the triangles alone
/// where a stage of the field finds no valid result, or is stopped. Throws ChainFailure.
void make_quads(ChainState& chain);

/// The separatrix graph of `files.graph` for the triangles and the field, with these words for critpoints beside the
/// chosen ones. Returns false as run_stage does.
bool make_graph(ChainState& chain, NodeFiles& files, const std::vector<std::string>& node_words);

}  // namespace quadrille::chain
