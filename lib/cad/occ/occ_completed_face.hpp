#pragma once
// A face of the kernel with all that the kernel's triangulation needs.

#include <TopoDS_Face.hxx>
#include <string>

namespace quadrille::occ {

/// The face with what triangles need and files leave out: parameter curves, poles, seams. Curves and points are not
/// changed. Throws FormatError, beginning with `file`, if its edges bound several parts.
TopoDS_Face completed(const TopoDS_Face& face, const std::string& file);

/// The diagonal of the box around the face, a length.
double box_diagonal(const TopoDS_Face& face);

}  // namespace quadrille::occ
