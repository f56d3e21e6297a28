#pragma once
// Shape measures of a triangle mesh, for reports.

#include "model/tri_mesh.hpp"

namespace quadrille::mesh {

/// Smallest angle of any element with straight edges between its vertices, radians.
double least_angle(const TriMesh& mesh);

/// Smallest ratio of shortest to longest edge of an element, with straight edges between its vertices.
double least_edge_ratio(const TriMesh& mesh);

}  // namespace quadrille::mesh
