#pragma once
// A swept mesh as structured solvers know it: the rectangular grids of its quads, times the layers.
//
// Everything about sides follows from the quads of one layer (layer_quads.hpp); the third index runs with the sweep, so
// that a grid is right-handed.

#include "export/groups.hpp"
#include "export/multi_block.hpp"
#include "model/hex_mesh.hpp"

namespace quadrille::exports {

/// The grids of hexahedra of order 1 (split_at_nodes of a mesh), with all levels of points. `groups`: of the mesh.
/// Throws ComputeError if a side, the bottom or the top of a grid has two names.
MultiBlock multi_block(const HexMesh& cells, const Groups& groups);

}  // namespace quadrille::exports
