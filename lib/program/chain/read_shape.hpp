#pragma once
// The first stage: from a CAD file, or points, to triangles.

#include "chain/chain_state.hpp"

namespace quadrille::chain {

/// Runs points2step if the shape is a file of points, by its ending or by the options, and cad2tri. Throws
/// ChainFailure.
void triangulate_shape(ChainState& chain);

}  // namespace quadrille::chain
