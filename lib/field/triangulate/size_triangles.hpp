#pragma once
// Sizes between the scattered points of a table: linear on the triangles of their Delaunay triangulation.

#include "model/size_sources.hpp"

namespace quadrille::triangulate {

/// Adds the triangles between all points; points in one line have none.
void add_size_triangles(SizeSources& sources);

}  // namespace quadrille::triangulate
