#pragma once
// Shifts of lines along the rows that they cross, after which they are nearly normal to the rows.
//
// The lines from a wall to the far side of its block connect equal fractions of both sides. Where these bend
// differently, as the nose of an aerofoil and a far field 20 chords away, lines are oblique to the layers. With the
// rows and the ends of the lines kept, vertex i of row j moves to x_ij on its row, in intervals of the row. The shifts
// x_ij - i minimise
//
//   sum over edges of lines  c^2 + c^4 / oblique^2      c the cotangent of the angle between the edge and its rows
//     + smoothness * sum over adjacent intervals of rows  (ln (w' / w) - ln (w0' / w0))^2
//     + excess_weight * sum over adjacent edges of rows and lines  max(0, |ln (d' / d)| - r)^2,
//
// w intervals of rows after and w0 before, d edges, r a part of the logarithm of the growth limit, or what the ratio
// was before. As edges grow with the distance from the wall, equal angles in all of them turn a line by as much for
// each factor of the distance: over 20 chords a small one suffices, and little of it lies in the layers.

#include <vector>

#include "layers/wall_layers.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::growth {

/// The vertices of a block. The lines cross the rows: line i consists of the vertices i of all rows.
struct VertexRows {
  std::vector<std::vector<Vec2>> rows;  ///< at least two, of at least two vertices
  int fixed_first = 1, fixed_last = 1;  ///< numbers of vertices, at least 1, that stay at both ends of each row
};

/// `limit`: of the ratio of adjacent edges, > 1. Cost: a sparse factorisation of the vertices' number in each step.
layers::RowShifts straightening_shifts(const VertexRows& block, double limit);

/// By block: the shifts of the lines along the normals of its walls (LayeredBlock::shifts), empty for blocks without
/// walls and for those that are not skew in `mesh` (mesh/mesh_score); empty if no block has any.
std::vector<layers::RowShifts> block_shifts(const BlockLayout& blocks, const layers::WallPlan& walls,
                                            const sizing::ArcDivisions& divisions, const QuadMesh& mesh, double limit);

/// Blocks that shifts do not make less skew lose these; returns whether any did. `straight`: the mesh with the shifts.
bool drop_useless(const QuadMesh& before, const QuadMesh& straight, std::vector<layers::RowShifts>& shifts);

}  // namespace quadrille::growth
