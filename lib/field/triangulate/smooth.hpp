#pragma once
// Moves inner vertices to improve the worst triangle around each; the connectivity does not change.

#include <vector>

#include "triangulate/draft.hpp"

namespace quadrille::triangulate {

/// Shape of a triangle: 4 sqrt(3) area / (sum of squared edges); 1 equilateral, 0 degenerate, negative inverted.
double triangle_shape(Vec2 a, Vec2 b, Vec2 c);

/// Moves the vertices with `is_free` towards the mean of their neighbours, each only if this improves the least shape
/// around it. `is_free` has one entry per vertex.
void smooth(Draft& draft, const std::vector<char>& is_free);

}  // namespace quadrille::triangulate
