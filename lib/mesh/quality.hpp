#pragma once
// Shape measures of a triangle mesh, for reports.

#include "model/tri_mesh.hpp"

namespace quadrille::mesh {

/// Smallest angle of any element, by its vertices, radians.
double least_angle(const TriMesh& mesh);

/// Smallest ratio of the shortest edge to the longest one of an element, by vertices.
double least_edge_ratio(const TriMesh& mesh);

}  // namespace quadrille::mesh
