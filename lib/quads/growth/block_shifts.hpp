#pragma once
// The blocks along walls whose lines are straightened (growth/straighten_lines), and what they gain by it.

#include <vector>

#include "layers/wall_layers.hpp"
#include "model/quad_mesh.hpp"
#include "sizing/arc_division.hpp"

namespace quadrille::growth {

/// By block: the shifts of the lines along the normals of its walls (LayeredBlock::shifts), empty for blocks without
/// walls and for those that are not skew in `mesh` (mesh/mesh_score); empty if no block has any.
std::vector<layers::RowShifts> block_shifts(const BlockLayout& blocks, const layers::WallPlan& walls,
                                            const sizing::ArcDivisions& divisions, const QuadMesh& mesh, double limit);

/// Blocks that shifts do not make less skew lose these; returns whether any did. `straight`: the mesh with the shifts.
bool drop_useless(const QuadMesh& before, const QuadMesh& straight, std::vector<layers::RowShifts>& shifts);

}  // namespace quadrille::growth
