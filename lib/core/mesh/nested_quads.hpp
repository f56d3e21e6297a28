#pragma once
// Nested refinement: every element becomes 2^K x 2^K elements of the same order, each the restriction of the element's
// own map to a part of the reference square.
//
// The refined mesh has exactly the same geometry, and its vertices include those of the mesh: sequences with K = 0, 1,
// 2, ... are nested, as convergence studies need them. Nothing comes nearer to the CAD curves.

#include "model/quad_mesh.hpp"

namespace quadrille::mesh {

/// The children of element e are 4^K e, 4^K e + 1, ..., along xi1 fastest; boundary and interface edges keep the curve
/// of the edge that they are part of. Vertices come first, those of `mesh` in their sequence with their coordinates,
/// bit for bit. Prescribed lengths become a 2^K-th; measured figures of elements are not filled in. `levels`: K >= 0.
QuadMesh nested_quads(const QuadMesh& mesh, int levels);

}  // namespace quadrille::mesh
