#pragma once
// The order of elements and vertices in a mesh of several regions.

#include <vector>

#include "model/tri_mesh.hpp"

namespace quadrille::triangulate {

/// Sorts elements, and vertices, by region, and sets mesh.region_elems. Regions must share no vertex. Returns the
/// former number of each vertex. A mesh of one region keeps its order.
std::vector<int> sort_by_region(TriMesh& mesh);

}  // namespace quadrille::triangulate
