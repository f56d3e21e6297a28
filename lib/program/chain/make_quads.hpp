#pragma once
// From triangles to quads: the graph for one choice of nodes, other nodes where those give no layout, blocks, quads.

#include "chain/chain_state.hpp"

namespace quadrille::chain {

/// The graph of `files.graph` for the triangles and the field, with these words for critpoints beside the chosen ones;
/// first a field of their own, if the nodes need one. Returns false as run_stage does.
bool make_graph(ChainState& chain, NodeFiles& files, const std::vector<std::string>& node_words);

/// The options of separatrix, with what makes midpoint division possible.
stage::SeparatrixOptions layout_options(const ChainState& chain);

/// Where separatrix could only divide triangles, its report proposes options of critpoints that change the nodes on a
/// strip of blocks that contains itself (quantize.remedies), or the grid around a body (other_grids). The first that
/// gives a layout replaces nodes, field and graph; if none does, or a stage is stopped, they stay. Options that the
/// user chose are not replaced, nor nodes that a user gave or edited.
void try_remedies(ChainState& chain);

/// Runs the stages between cad2tri and quadexport. With the layout `auto`, the quads are made from the triangles alone
/// where a stage of the field finds no valid result, or is stopped. Throws ChainFailure.
void make_quads(ChainState& chain);

}  // namespace quadrille::chain
