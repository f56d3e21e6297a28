#pragma once
// Which triangles make blocks that are not proved valid, or that are nearly degenerate.
//
// A straight triangle of determinant D (twice its area) makes straight blocks whose Jacobian, on [0, 1]^2, has the
// Bernstein coefficients D/4 at the vertex, D/6 at the middles and D/12 at the centre: they need no proof. Blocks
// beside a curved boundary are measured as quads of order 8 (mesh/transfinite.hpp).

#include <vector>

#include "curve/chain.hpp"
#include "midpoint/divide_triangles.hpp"

namespace quadrille::midpoint {

/// A lower bound of det J on [0, 1]^2 of the block with these sides, counter-clockwise; an area. `table` must have the
/// curves of `graph`.
double jacobian_bound(const curve::CurveTable& table, const ArcGraph& graph, const std::array<HalfEdge, 4>& sides);

/// The triangles, ascending, with a curved edge and a block whose Jacobian may fall below a tenth of D/12.
std::vector<int> doubtful_triangles(const TriMesh& mesh, const DividedTriangles& divided);

}  // namespace quadrille::midpoint
