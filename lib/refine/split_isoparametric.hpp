#pragma once
// The elements of all blocks, sampled from the exact block maps.

#include <vector>

#include "curve/chain.hpp"
#include "layers/wall_layers.hpp"
#include "model/block_layout.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::refine {

/// Nodes, elements, blocks and boundary edges of the mesh of order N whose elements end at `arc_ends` (fractions of
/// each arc's length, refine/divide_arcs). Nodes on arcs are made once and shared by the blocks on both sides; those of
/// the layout's nodes come first. Element (i, j) of a block lies i along side 0, j along side 1, i fastest. Proofs are
/// not filled in. Where there are walls, the nodes of the blocks along them lie in layers (layers/layer_columns).
QuadMesh split_isoparametric(const BlockLayout& layout, const std::vector<curve::Chain>& chains,
                             const std::vector<std::vector<double>>& arc_ends, int order,
                             const layers::WallPlan* walls = nullptr);

}  // namespace quadrille::refine
