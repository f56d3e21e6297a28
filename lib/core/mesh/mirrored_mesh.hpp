#pragma once
// The triangle mesh that the mesh of one half and its mirror image make.

#include "curve/mirrored_face.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::mesh {

/// `half`: of one region; `face`: mirrored_face() of its face at `line`. Element e of the half is element e of the
/// whole, and its mirror image is element e + half.num_elems(), with its second and third vertex exchanged. The
/// vertices on the line belong to both.
TriMesh mirrored_mesh(const TriMesh& half, const curve::MirroredFace& face, const curve::SymmetryLine& line);

}  // namespace quadrille::mesh
