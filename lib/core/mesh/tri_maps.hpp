#pragma once
// The maps of all elements of a triangle mesh.

#include <vector>

#include "model/tri_mesh.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::mesh {

/// One map per element: affine, or of the mesh's order for the elements listed in curved_elems.
std::vector<spectral::TriMap> tri_maps(const TriMesh& mesh);

}  // namespace quadrille::mesh
