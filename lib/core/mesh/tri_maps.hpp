#pragma once
// The maps of all elements of a triangle mesh, and measures of their shapes for reports.

#include <vector>

#include "model/tri_mesh.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::mesh {

/// One map per element: affine, or of the mesh's order for the elements listed in curved_elems.
std::vector<spectral::TriMap> tri_maps(const TriMesh& mesh);

/// Smallest angle of any element with straight edges between its vertices, radians.
double least_angle(const TriMesh& mesh);

/// Smallest ratio of shortest to longest edge of an element, with straight edges between its vertices.
double least_edge_ratio(const TriMesh& mesh);

}  // namespace quadrille::mesh
