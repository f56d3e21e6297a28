#pragma once
// From triangles to quads, by the field or without it.

#include "chain/chain_state.hpp"

namespace quadrille::chain {

/// Runs the stages between cad2tri and quadexport. With the layout `auto`, the quads are made from the triangles alone
/// where a stage of the field finds no valid result, or is stopped. Throws ChainFailure.
void make_quads(ChainState& chain);

}  // namespace quadrille::chain
