#pragma once
// The loops of a face in space, from its triangulation: the topology of a surface whose parameters may have seams and
// poles is that of its triangles.

#include <vector>

#include "space/raw_space_face.hpp"

namespace quadrille::space {

/// An edge of the face with the face on its left: forwards, or against the direction of its curve.
struct LoopEdge {
  int polygon = 0;  ///< index into RawSpaceFace::polygons
  bool is_reversed = false;
};

/// The loops with the face on their left, seen against the normal; each begins with the edge that comes first in the
/// file. The longest loop comes first, the others in the order of the file. Edges with the face on both sides (seams,
/// slits) are in none. Throws FormatError unless the triangles are an orientable surface with a boundary, whose loops
/// do not touch each other and consist of whole edges, or if the surface has a handle.
std::vector<std::vector<LoopEdge>> boundary_loops(const RawSpaceFace& raw);

}  // namespace quadrille::space
