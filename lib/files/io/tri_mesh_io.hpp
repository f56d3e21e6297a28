#pragma once
// Writes and reads the members of a triangle mesh, in a file of its own or inside a field file. Private to io.

#include "io/archive.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::io {

void describe_tri_mesh(Archive& archive, TriMesh& mesh);

}  // namespace quadrille::io
