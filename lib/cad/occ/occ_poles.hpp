#pragma once
// Edges that run through a pole of their surface, as CAD programs write them whose surfaces have no poles.

#include <TopoDS_Face.hxx>

namespace quadrille::occ {

/// The face with a vertex on its edges wherever they run through a pole of its surface: the kernel's parameter curves
/// jump there. Both parts of an edge have its curve.
TopoDS_Face split_at_poles(const TopoDS_Face& face);

}  // namespace quadrille::occ
