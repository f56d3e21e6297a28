#pragma once
// Outlines of curved elements in pixels.

#include <vector>

#include "draw/picture.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::draw {

/// One map per element, as mesh/tri_maps makes them (a layer that draw does not see).
std::vector<spectral::TriMap> element_maps(const TriMesh& mesh);

/// The closed outline of a triangle.
PathData tri_outline(const Picture& picture, const spectral::TriMap& map);

/// The side of a quad from corner `side` to the next, as position and derivative along s in [0, 1], in pixels.
PixelCurve quad_side(const Picture& picture, const QuadMesh& mesh, int elem, int side);

/// The closed outline of a quad.
PathData quad_outline(const Picture& picture, const QuadMesh& mesh, int elem);

/// The node at (i, j) of the element, counted from the first corner of `side`: j = 0 is the side itself.
int quad_side_node(const QuadMesh& mesh, int elem, int side, int i);

}  // namespace quadrille::draw
