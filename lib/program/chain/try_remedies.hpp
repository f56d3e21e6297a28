#pragma once
// Other nodes where those of the field give no layout, or a poor one.

#include "chain/chain_state.hpp"

namespace quadrille::chain {

/// Where separatrix could only divide triangles, its report proposes options of critpoints that change the nodes on a
/// strip of blocks that contains itself (quantize.remedies), or the grid around a body (other_grids). The first that
/// gives a layout replaces nodes, field and graph; if none does, or a stage is stopped, they stay. Options that the
/// user chose are not replaced, nor nodes that a user gave or edited.
void try_remedies(ChainState& chain);

/// Where the mesh of the blocks has faults (is not valid, has an edge ratio above 100, a scaled Jacobian below 0.3 or a
/// resolution ratio above 25), or a resolution ratio above 2 outside far fields, nodes at the least energy are tried
/// (critpoints --place energy), and taken if their mesh is better: with fewer faults, else with a resolution ratio that
/// is less by 5 %. While the best mesh has faults, so are the fewest nodes (--nodes fewest), or in a far field the
/// other grids (--topology). All are made without options of quadrefine whatever the user asks for, so that blocks do
/// not depend on sizes; on a curved face or in a far field with order 2, without rings, with vertices nearly in place,
/// at any distance from the surface. Nothing changes with more than 24 nodes, with layers along walls, or where a user
/// chose nodes or where they are placed. Needs the blocks. Returns whether one of these meshes is that of the run: the
/// best, if it is valid and the user gave no option of quadrefine, on a planar face without a far field.
bool try_better_nodes(ChainState& chain);

}  // namespace quadrille::chain
