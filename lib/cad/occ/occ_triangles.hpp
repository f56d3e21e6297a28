#pragma once
// Edges and fine triangles of a curved OpenCASCADE face.

#include <TopoDS_Face.hxx>

#include "base/report.hpp"
#include "occ/occ_model.hpp"
#include "space/raw_space_face.hpp"

namespace quadrille::occ {

/// Sets surface, curves, triangles and polygons of `raw`, whose labels have all but the wire, which is set too. What
/// the file leaves out is added on the way: parameter curves, seams, poles. Warns of approximations. Throws FormatError
/// if the kernel finds no triangles.
void read_curved_face(const OccModel& model, const TopoDS_Face& face, space::RawSpaceFace& raw, Report& report);

}  // namespace quadrille::occ
