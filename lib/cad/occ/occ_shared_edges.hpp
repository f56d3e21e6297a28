#pragma once
// Faces that were drawn one by one: edges that lie upon each other become one edge.

#include <TopoDS_Face.hxx>
#include <vector>

namespace quadrille::occ {

/// The face with one vertex where an edge of a wire ends and the next one begins, within `tolerance`, a length: IGES
/// has no vertices that edges share.
TopoDS_Face with_shared_vertices(const TopoDS_Face& face, double tolerance);

/// The faces, in their order and with their edges in the same order, with one vertex for vertices of different faces
/// within `tolerance` of each other, a length, and one edge for edges between the same vertices that are as near to
/// each other, of one face too, as both sides of a seam in IGES: the first of them. An edge on a part of another one
/// stays.
std::vector<TopoDS_Face> with_shared_edges(std::vector<TopoDS_Face> faces, double tolerance);

}  // namespace quadrille::occ
