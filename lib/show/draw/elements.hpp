#pragma once
// Outlines of curved elements in pixels.

#include <vector>

#include "draw/picture.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::draw {

/// The closed outline of a triangle.
PathData tri_outline(const Picture& picture, const spectral::TriMap& map);

/// The side of a quad from corner `side` to the next, as position and derivative along s in [0, 1], in pixels.
PixelCurve quad_side(const Picture& picture, const QuadMesh& mesh, int elem, int side);

/// The closed outline of a quad.
PathData quad_outline(const Picture& picture, const QuadMesh& mesh, int elem);

}  // namespace quadrille::draw
