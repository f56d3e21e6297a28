#pragma once
// Better shapes for the CAD kernel's triangles of a curved face: near poles and beside curved edges the kernel makes
// triangles without area, or turned over in space.

#include "space/raw_space_face.hpp"

namespace quadrille::space {

/// Swaps diagonals where the worse of two triangles gets better, removes inner vertices of triangles that stay bad, and
/// splits sides whose middle lies off the surface by more than 1e-3 of the size of the face. Vertices and sides on
/// edges of the file stay.
void improve_triangles(RawSpaceFace& raw);

}  // namespace quadrille::space
