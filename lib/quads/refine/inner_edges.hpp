#pragma once
// The shape of the edges inside a mesh.
//
// An element of order p contains all polynomials of degree p only if its map is bilinear; with a map of order g it
// contains those of degree floor(p / g). Edges inside are therefore straight where they can be. With eta the distance
// from a side in the reference square, 0 to 1, and d the displacement of that side from its chord, an element is
//
//   bilinear + sum over its curved sides of d (1 - eta)^2,    or d (1 - eta) where the opposite side is curved as well:
//
// the curvature of the boundary fades within one row. An edge keeps its curve if one of its elements would otherwise
// not be proved valid, or have a scaled Jacobian below min(0.6, that with its curves): of the edges of such an element
// first the one that bends most. An element whose edges all keep their curves keeps all its nodes.

#include <vector>

#include "model/quad_mesh.hpp"
#include "refine/refine_options.hpp"

namespace quadrille::refine {

/// Shapes the edges that lie on no CAD curve, and measures the elements (refine/validity); no vertex moves. `kept`: by
/// element, whether it keeps all its nodes; empty: none does. O(n) for n elements.
void shape_inner_edges(QuadMesh& mesh, InnerEdges shape, const std::vector<bool>& kept = {});

}  // namespace quadrille::refine
