#pragma once
// The members of a triangle mesh, as a file of its own or inside a field file. Private to io.

#include "io/archive.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::io {

void describe_tri_mesh(Archive& archive, TriMesh& mesh);

}  // namespace quadrille::io
