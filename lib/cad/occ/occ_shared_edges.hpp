#pragma once
// Faces that were drawn one by one: edges that lie upon each other become one edge.

#include <TopoDS_Face.hxx>
#include <vector>

namespace quadrille::occ {

/// The faces, in their order and with their edges in the same order, with one vertex for vertices of different faces
/// within `tolerance` of each other, a length, and one edge for edges between the same vertices that are as near to
/// each other: those of the first face. An edge on a part of another one stays.
std::vector<TopoDS_Face> with_shared_edges(std::vector<TopoDS_Face> faces, double tolerance);

}  // namespace quadrille::occ
