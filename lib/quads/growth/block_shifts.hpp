#pragma once
// The blocks along walls whose lines are straightened (growth/straighten_lines), and what they gain by it.

#include <vector>

#include "layers/wall_layers.hpp"
#include "model/quad_mesh.hpp"
#include "sizing/arc_division.hpp"

namespace quadrille::growth {

/// By block: the shifts of the lines along the normals of its walls (LayeredBlock::shifts), empty for blocks without
/// walls and for those that have StraightenConstants::good_quality in `mesh`; empty if no block has any.
std::vector<mesh::RowShifts> block_shifts(const BlockLayout& blocks, const layers::WallPlan& walls,
                                          const sizing::ArcDivisions& divisions, const QuadMesh& mesh, double limit);

/// Blocks lose their shifts if these do not improve them by StraightenConstants::least_gain; returns whether any did.
/// `straight`: the mesh with the shifts.
bool drop_useless(const QuadMesh& before, const QuadMesh& straight, std::vector<mesh::RowShifts>& shifts);

/// Whether a mesh with straightened lines is to be preferred: it grows hardly more than the other or the limit, or
/// the other has a block worse than GrowthConstants::good_quality and is worse.
bool is_better(const QuadMesh& straight, const QuadMesh& other, double limit);

}  // namespace quadrille::growth
