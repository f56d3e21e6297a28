#pragma once
// Sizes between the scattered points of a table: linear on the triangles of their Delaunay triangulation.

#include <vector>

#include "base/vec2.hpp"
#include "model/size_sources.hpp"

namespace quadrille::triangulate {

/// Adds the triangles between all points; points in one line have none. `positions`: of the points, in the plane or, on
/// a curved face, in its chart.
void add_size_triangles(SizeSources& sources, const std::vector<Vec2>& positions);

}  // namespace quadrille::triangulate
