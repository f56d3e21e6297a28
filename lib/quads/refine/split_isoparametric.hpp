#pragma once
// The elements of all blocks, sampled from the exact block maps.

#include "growth/line_intervals.hpp"
#include "layers/wall_layers.hpp"
#include "model/quad_mesh.hpp"
#include "sizing/arc_division.hpp"
#include "sizing/measured_layout.hpp"

namespace quadrille::refine {

/// Nodes, elements, blocks and boundary edges of the mesh of order N whose elements end at the positions in `divisions`
/// (one per arc). Nodes on arcs are made once and shared by the blocks on both sides; nodes at the layout's nodes are
/// numbered first. Element (i, j) of a block lies i along side 0, j along side 1, i fastest. Jacobian bounds and
/// qualities are not filled in. With `walls`, nodes of the blocks along them lie in layers (layers/layered_block); with
/// `lines`, which need `walls`, lines inside all blocks are divided accordingly.
QuadMesh split_isoparametric(const sizing::MeasuredLayout& measured, const sizing::ArcDivisions& divisions, int order,
                             const layers::WallPlan* walls = nullptr, const growth::LinePlan& lines = {});

}  // namespace quadrille::refine
