#pragma once
// The faces in which a plane cuts the solids of a model. No OpenCASCADE types.

#include <string>

#include "base/report.hpp"
#include "cad/loaded_face.hpp"
#include "occ/kernel_format.hpp"

namespace quadrille::occ {

/// A model of the faces of the cut, solid by solid: each with the labels of its solid, and its edges with the name of
/// the solid's face that they lie in, or "face_N" after its number in list_faces. Throws FormatError, with a remedy, if
/// the model has no solid, if the plane cuts none, and if a face of one lies in the plane, where the cut jumps. Curves
/// of the cut that are no conics are the kernel's splines: `report` warns of their distance from the faces.
OccModel section(const OccModel& model, const cad::SectionPlane& plane, const std::string& name, Report& report);

}  // namespace quadrille::occ
