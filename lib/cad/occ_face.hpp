#pragma once
// The only face of an OpenCASCADE model, as NURBS of its own plane.

#include "base/report.hpp"
#include "cad/occ_model.hpp"
#include "cad/raw_face.hpp"

namespace quadrille::cad {

/// Throws FormatError unless `model` holds exactly one planar face bounded by plain wires; what lies beside the face
/// becomes warnings.
RawFace occ_face(const OccModel& model, const std::string& file, Report& report);

}  // namespace quadrille::cad
