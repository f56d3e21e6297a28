#pragma once
// The elements of all blocks, sampled from the exact block maps.

#include <array>
#include <vector>

#include "growth/line_intervals.hpp"

namespace quadrille::refine {

/// The nodes of an arc or of a block's side: the Gauss-Lobatto-Legendre points of every interval, ends shared.
struct ArcNodes {
  std::vector<double> fractions;  ///< of the arc's length, ascending from 0 to 1
  std::vector<int> ids;           ///< in the mesh
};

/// Appends the inner nodes of one arc to the mesh, which begins with the nodes of the layout. In the arc's own
/// direction; with `walls` an arc that starts at a wall has the nodes of its layers.
ArcNodes place_on_arc(const sizing::MeasuredLayout& measured, int arc, const sizing::ArcDivision& division,
                      const layers::WallPlan* walls, QuadMesh& mesh);

/// The sides of a block, each in the direction of rising s (sides 0, 2) or t (sides 1, 3). `arc_nodes` by arc.
std::array<ArcNodes, 4> side_nodes(const BlockLayout& layout, int block, const std::vector<ArcNodes>& arc_nodes);

/// Nodes, elements, blocks and boundary edges of the mesh of order N whose elements end at the positions in `divisions`
/// (one per arc). Nodes on arcs are made once and shared by the blocks on both sides; nodes at the layout's nodes are
/// numbered first. Element (i, j) of a block lies i along side 0, j along side 1, i fastest. Jacobian bounds and
/// qualities are not filled in. With `walls`, nodes of the blocks along them lie in layers (layers/layered_block); with
/// `lines`, which need `walls`, lines inside all blocks are divided accordingly. Nodes inside halved blocks are
/// those of the whole.
QuadMesh split_isoparametric(const sizing::MeasuredLayout& measured, const sizing::ArcDivisions& divisions, int order,
                             const layers::WallPlan* walls = nullptr, const growth::LinePlan& lines = {});

}  // namespace quadrille::refine
